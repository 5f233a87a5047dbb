#pragma once

#include <stdexcept>
#include <string>

#include "structure_from_wifi/export.h"

namespace sfw {

/// Input that cannot be used. what() names the file, line or setting and the remedy. Each problem
/// has its own line.
class SFW_EXPORT InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace sfw
