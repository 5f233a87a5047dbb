#include "k_visibility/rssi_filter.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sfw {
namespace {

template <class Centre>
std::vector<double> slide(const std::vector<double>& values, std::size_t window, Centre&& centre) {
  std::vector<double> filtered(values.size());
  std::vector<double> neighbours;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t reach = std::min({window / 2, i, values.size() - 1 - i});
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(i - reach);
    neighbours.assign(first, first + static_cast<std::ptrdiff_t>(2 * reach + 1));
    filtered[i] = centre(neighbours);
  }
  return filtered;
}

}  // namespace

std::vector<double> slidingMedian(const std::vector<double>& values, std::size_t window) {
  return slide(values, window, [](std::vector<double>& neighbours) {
    const auto middle = neighbours.begin() + static_cast<std::ptrdiff_t>(neighbours.size() / 2);
    std::nth_element(neighbours.begin(), middle, neighbours.end());
    return *middle;
  });
}

std::vector<double> slidingMean(const std::vector<double>& values, std::size_t window) {
  return slide(values, window, [](const std::vector<double>& neighbours) {
    return std::accumulate(neighbours.begin(), neighbours.end(), 0.0) /
           static_cast<double>(neighbours.size());
  });
}

double withoutPathLoss(double rssi_dbm, double distance_m, double exponent) {
  constexpr double kNearest = 0.3;  // [m]
  return rssi_dbm + 10.0 * exponent * std::log10(std::max(distance_m, kNearest));
}

}  // namespace sfw
