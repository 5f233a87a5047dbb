#include "localization/map_folds.h"

#include <algorithm>
#include <cmath>

#include "radio/nearest_neighbours.h"

namespace sfw {

std::vector<int> foldsOf(const std::vector<Scan>& scans, double block_m) {
  constexpr double kFewestBlocks = 4.0;
  const std::vector<double> way_m = wayOf(scans);
  const double length_m = way_m.back();
  const double blocks = std::max(length_m / block_m, kFewestBlocks);
  std::vector<int> folds(scans.size());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const double share = length_m > 0.0
                             ? way_m[i] / length_m
                             : static_cast<double>(i) / static_cast<double>(scans.size());
    folds[i] = static_cast<int>(std::floor(share * blocks)) % 2;
  }
  return folds;
}

double distanceBetweenFolds(const std::vector<Scan>& scans, const std::vector<int>& folds) {
  constexpr double kMostM = 4.0;
  std::vector<Position> positions;
  for (const Scan& scan : scans) {
    positions.push_back(scan.position);
  }
  double squares = 0.0;
  for (const int fold : {0, 1}) {
    NearestNeighbours others(positions);
    for (std::size_t i = 0; i < scans.size(); ++i) {
      if (folds[i] != fold) {
        others.enter(static_cast<int>(i));
      }
    }
    for (std::size_t i = 0; i < scans.size(); ++i) {
      if (folds[i] == fold) {
        const auto& nearest = others.nearest(positions[i], 1);
        squares +=
            nearest.empty() ? kMostM * kMostM : std::min(nearest.front().first, kMostM * kMostM);
      }
    }
  }
  return std::sqrt(squares / static_cast<double>(scans.size()));
}

}  // namespace sfw
