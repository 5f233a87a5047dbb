#include "evaluation/area_under_curve.h"

#include <algorithm>

namespace sfw {

std::optional<double> areaUnderCurve(Ratings ratings) {
  if (ratings.free.empty() || ratings.wall.empty()) {
    return std::nullopt;
  }
  std::sort(ratings.free.begin(), ratings.free.end());
  double won = 0.0;
  for (const double rating : ratings.wall) {
    const auto [below, above] = std::equal_range(ratings.free.begin(), ratings.free.end(), rating);
    won +=
        0.5 * static_cast<double>((below - ratings.free.begin()) + (above - ratings.free.begin()));
  }
  return won / static_cast<double>(ratings.wall.size()) / static_cast<double>(ratings.free.size());
}

}  // namespace sfw
