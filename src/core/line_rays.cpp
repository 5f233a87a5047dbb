#include "line_rays.h"

namespace sfw {
namespace {

SignalPrecision precisionOf(const HeardAccessPoint& heard, const ShadowingModel& model) {
  std::vector<Position> places;
  std::vector<double> noise;
  std::vector<double> loss;
  for (const RadioBin& bin : heard.bins) {
    places.push_back(bin.place);
    noise.push_back(heard.noise_db2 / bin.readings);
    loss.push_back(logDistance(heard, bin.place));
  }
  return {places, noise, loss, model};
}

}  // namespace

Rays::Rays(const GridGeometry& geometry, const HeardAccessPoint& heard, const ShadowingModel& model,
           Unknowns& unknowns)
    : begin_{0}, precision_(precisionOf(heard, model)) {
  unexplained_.resize(static_cast<Eigen::Index>(heard.bins.size()));
  for (std::size_t i = 0; i < heard.bins.size(); ++i) {
    const RadioBin& bin = heard.bins[i];
    forEachLine(geometry, heard.position, bin.place, [&](bool across_x, Cell cell) {
      const std::int32_t id =
          unknowns.at(across_x ? Direction::kAcrossX : Direction::kAcrossY, cell);
      if (id != Unknowns::kNone) {
        crossed_.push_back(id);
      }
    });
    begin_.push_back(crossed_.size());
    const double loss = logDistance(heard, bin.place);
    unexplained_[static_cast<Eigen::Index>(i)] =
        bin.rssi_dbm - (kPriorPower - kPriorExponent * loss);
  }
}

Eigen::VectorXd Rays::along(const Eigen::VectorXf& x) const {
  Eigen::VectorXd sums(static_cast<Eigen::Index>(size()));
  for (std::size_t ray = 0; ray < size(); ++ray) {
    float even = 0.0F, odd = 0.0F;  // two, as each addition waits for the one before
    std::size_t i = begin_[ray];
    for (; i + 1 < begin_[ray + 1]; i += 2) {
      even += x[crossed_[i]];
      odd += x[crossed_[i + 1]];
    }
    even += i < begin_[ray + 1] ? x[crossed_[i]] : 0.0F;
    sums[static_cast<Eigen::Index>(ray)] = static_cast<double>(even + odd);
  }
  return sums;
}

void Rays::spread(const Eigen::VectorXd& values, Eigen::VectorXf& sums) const {
  for (std::size_t ray = 0; ray < size(); ++ray) {
    const auto value = static_cast<float>(values[static_cast<Eigen::Index>(ray)]);
    for (std::size_t i = begin_[ray]; i < begin_[ray + 1]; ++i) {
      sums[crossed_[i]] += value;
    }
  }
}

}  // namespace sfw
