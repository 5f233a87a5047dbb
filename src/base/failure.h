#pragma once

#include <exception>
#include <new>
#include <string>

namespace sfw {

/// What a failure says to people. The words of std::bad_alloc alone would help nobody.
inline std::string reasonOf(const std::exception& error) {
  return dynamic_cast<const std::bad_alloc*>(&error) != nullptr
             ? "out of memory; raise map/resolution or map a smaller area"
             : error.what();
}

}  // namespace sfw
