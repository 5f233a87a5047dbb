#pragma once

#include <string>

namespace sfw {

/// The warning for an old name that this release still accepts.
inline std::string oldNameWarning(const std::string& old_name, const std::string& name) {
  return old_name + " is now called " + name +
         "; rename it, the next release does not know the old name";
}

}  // namespace sfw
