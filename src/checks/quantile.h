#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace sfw {

/// The value below which a share of the values lies; 0 without values. O(values)
inline double quantile(std::vector<double> values, double share) {
  if (values.empty()) {
    return 0.0;
  }
  const auto last = static_cast<double>(values.size() - 1);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * last);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace sfw
