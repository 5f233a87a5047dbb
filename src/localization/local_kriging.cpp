#include "localization/local_kriging.h"

namespace sfw {

LocalKriging::LocalKriging(const std::vector<Position>& positions,
                           const std::vector<double>& noise_db2, const SignalCovariance& covariance)
    : positions_(positions), noise_db2_(noise_db2), covariance_(covariance), nearest_(positions) {
  for (std::size_t i = 0; i < positions.size(); ++i) {
    nearest_.enter(static_cast<int>(i));
  }
}

void LocalKriging::set(int lane, const Position& position, double own_db2, int left_out) {
  rows_.put(lane, 0, position, own_db2);
  std::array<int, kNeighbours>& bins = bins_[static_cast<std::size_t>(lane)];
  bins.fill(0);
  int used = 0;
  for (const auto& [square, number] : nearest_.nearest(position, kNeighbours + 1)) {
    if (number == left_out || used == kNeighbours) {
      continue;
    }
    const auto bin = static_cast<std::size_t>(number);
    bins[static_cast<std::size_t>(used++)] = number;
    rows_.put(lane, used, positions_[bin], noise_db2_[bin] + covariance_.nugget_db2);
  }
  while (used < kNeighbours) {
    rows_.putNone(lane, ++used);
  }
}

}  // namespace sfw
