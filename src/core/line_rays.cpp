#include "line_rays.h"

#include <algorithm>
#include <utility>

namespace sfw {

Unknowns::Unknowns(const GridGeometry& geometry)
    : width_(geometry.width()), height_(geometry.height()), number_(2 * geometry.size(), kNone) {}

void Unknowns::number() {
  for (std::size_t slot = 0; slot < number_.size(); ++slot) {
    if (number_[slot] != kNone) {
      number_[slot] = static_cast<std::int32_t>(slots_.size());
      slots_.push_back(static_cast<std::int32_t>(slot));
    }
  }
}

Eigen::ArrayXf Unknowns::continued() const {
  Eigen::ArrayXf continued =
      Eigen::ArrayXf::Zero(std::max<Eigen::Index>(static_cast<Eigen::Index>(slots_.size()) - 1, 0));
  for (std::size_t i = 0; i + 1 < slots_.size(); ++i) {
    const std::int64_t line = isAcrossX(slots_[i]) ? height_ : width_;
    const std::int64_t place = isAcrossX(slots_[i]) ? slots_[i] : slots_[i] - width_ * height_;
    const bool ends = (place + 1) % line == 0;
    continued[static_cast<Eigen::Index>(i)] = slots_[i + 1] == slots_[i] + 1 && !ends ? 1.0F : 0.0F;
  }
  return continued;
}

Rays::Rays(const GridGeometry& geometry, const std::vector<HeardAccessPoint>& heard,
           const Mask& driven, const std::atomic<bool>& stop)
    : unknowns_(geometry) {
  SparseSums::Choice crossed;  // slots by ray
  for (const HeardAccessPoint& one : heard) {
    for (const RadioBin& bin : one.bins) {
      if (stop) {
        return;
      }
      const auto ray = static_cast<std::int32_t>(size_++);
      forEachLine(geometry, one.position, bin.place, [&](bool across_x, Cell cell) {
        if (driven[cell] == 0) {
          const std::int32_t slot = unknowns_.slot(across_x, cell);
          unknowns_.add(slot);
          crossed.sum.push_back(ray);
          crossed.term.push_back(slot);
        }
      });
    }
  }
  unknowns_.number();
  for (std::int32_t& slot : crossed.term) {
    slot = unknowns_.in(slot);
  }
  along_ = SparseSums(size_, unknowns_.size(), crossed);
  spread_ = SparseSums(unknowns_.size(), size_, SparseSums::transposed(std::move(crossed)));
}

}  // namespace sfw
