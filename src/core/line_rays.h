#pragma once

#include <Eigen/Core>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sparse_sums.h"
#include "structure_from_wifi/line_field.h"

namespace sfw {

/// The unknowns: pieces of wall that some ray crosses and that stand where no robot was.
///
/// Numbered wall line by wall line, so what continues a piece has the next number, and nothing that
/// is done to neighbours along a wall has to look them up.
class Unknowns {
 public:
  /// @param geometry  must outlive this
  explicit Unknowns(const GridGeometry& geometry);

  static constexpr std::int32_t kNone = -1;

  /// Place of a piece among all that the grid could have, along its wall line.
  std::int32_t slot(bool across_x, Cell cell) const {
    return static_cast<std::int32_t>(across_x ? cell.x * height_ + cell.y
                                              : (height_ + cell.y) * width_ + cell.x);
  }

  /// Makes a slot's piece an unknown.
  void add(std::int32_t slot) { number_[static_cast<std::size_t>(slot)] = 0; }

  /// Gives all unknowns their numbers, once all are added.
  void number();

  std::size_t size() const { return slots_.size(); }

  /// The unknown in a slot, or kNone.
  std::int32_t in(std::int32_t slot) const { return number_[static_cast<std::size_t>(slot)]; }

  /// For each unknown but the last one whether the next one continues its wall: 1 or 0.
  Eigen::ArrayXf continued() const;

  /// Calls `visit(number, across_x, Cell)` for each unknown.
  template <class Visitor>
  void forEach(Visitor&& visit) const;

 private:
  bool isAcrossX(std::int32_t slot) const { return slot < width_ * height_; }

  std::int64_t width_;
  std::int64_t height_;
  std::vector<std::int32_t> number_;  // by slot
  std::vector<std::int32_t> slots_;   // by number
};

/// All access points' rays, one after another, and the unknowns that each of them crosses.
class Rays {
 public:
  /// @param driven  cells where no wall can stand
  /// @param stop    polled; when it turns true there are no unknowns
  Rays(const GridGeometry& geometry, const std::vector<HeardAccessPoint>& heard, const Mask& driven,
       const std::atomic<bool>& stop);

  const Unknowns& unknowns() const { return unknowns_; }

  /// How many rays there are.
  std::size_t size() const { return size_; }

  /// Sets `sums` to those of `x` over the unknowns that each ray crosses.
  void along(const Eigen::VectorXf& x, Eigen::VectorXf& sums) const { along_.of(x, sums); }

  /// Sets `sums` to those of `values` over the rays that cross each unknown.
  void spread(const Eigen::VectorXf& values, Eigen::VectorXf& sums) const {
    spread_.of(values, sums);
  }

 private:
  Unknowns unknowns_;
  std::size_t size_ = 0;
  SparseSums along_;
  SparseSums spread_;
};

template <class Visitor>
void Unknowns::forEach(Visitor&& visit) const {
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const std::int64_t slot = slots_[i];
    if (isAcrossX(slots_[i])) {
      visit(static_cast<Eigen::Index>(i), true, Cell{slot / height_, slot % height_});
    } else {
      const std::int64_t row_major = slot - width_ * height_;
      visit(static_cast<Eigen::Index>(i), false, Cell{row_major % width_, row_major / width_});
    }
  }
}

}  // namespace sfw
