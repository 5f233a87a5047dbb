#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace sfw {

/// Collects the settings that lie outside their ranges, by name; a value that is no number does.
class RangeCheck {
 public:
  explicit RangeCheck(std::vector<std::string>& problems) : problems_(problems) {}

  void operator()(double value, double low, double high, const char* name) const {
    if (!(value >= low && value <= high)) {
      char text[96];
      std::snprintf(text, sizeof text, "%s must lie in %g..%g", name, low, high);
      problems_.emplace_back(text);
    }
  }

 private:
  std::vector<std::string>& problems_;
};

}  // namespace sfw
