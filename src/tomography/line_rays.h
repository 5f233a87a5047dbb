#pragma once

#include <Eigen/Core>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tomography/line_field.h"
#include "tomography/sparse_sums.h"

namespace sfw {

/// Numbers the unknowns: the pieces of wall that a ray crosses outside the robot's path.
///
/// Numbers run along one wall line after another. So the next piece of a wall has the next number,
/// and no search for neighbours along a wall is needed.
class Unknowns {
 public:
  /// One of the directions that walls may have.
  struct Direction {
    std::size_t lattice;  ///< index
    bool walls_along_y;   ///< along the lattice's y axis, otherwise along x
  };

  /// No piece is an unknown yet.
  explicit Unknowns(const std::vector<LineLattice>& lattices);

  static constexpr std::int32_t kNone = -1;

  /// Number of a piece among all pieces of all lattices, unknown or not.
  std::int32_t slot(const Direction& direction, Cell cell) const {
    const Block& block = blocks_[2 * direction.lattice + (direction.walls_along_y ? 0 : 1)];
    return static_cast<std::int32_t>(block.first + (direction.walls_along_y
                                                        ? cell.x * block.along + cell.y
                                                        : cell.y * block.along + cell.x));
  }

  /// Makes the piece in a slot an unknown.
  void add(std::int32_t slot) { number_[static_cast<std::size_t>(slot)] = 0; }

  /// Numbers all unknowns. Call it once, after the last add().
  void number();

  std::size_t size() const { return slots_.size(); }

  /// The unknown in a slot, or kNone.
  std::int32_t in(std::int32_t slot) const { return number_[static_cast<std::size_t>(slot)]; }

  /// For each unknown but the last: 1 if the next one continues its wall, otherwise 0.
  Eigen::ArrayXf continued() const;

  /// Calls `visit(number, Direction, Cell)` for each unknown, in their order.
  template <class Visitor>
  void forEach(Visitor&& visit) const;

 private:
  /// The slots of a direction's wall lines, one line after another.
  struct Block {
    Direction direction;
    std::int64_t first;  // slot
    std::int64_t along;  // slots of a line
    std::int64_t end;    // slot behind the last
  };

  /// Calls `visit(number, Block, slot within the block)` for each unknown, in their order.
  template <class Visitor>
  void forEachSlot(Visitor&& visit) const;

  std::vector<Block> blocks_;
  std::vector<std::int32_t> number_;  // by slot
  std::vector<std::int32_t> slots_;   // by number
};

/// The rays from all access points to their bins, and the unknowns that each ray crosses.
class Rays {
 public:
  /// @param driven  for each lattice, the cells where no wall can stand
  /// @param stop    polled; when it turns true there are no unknowns
  Rays(const std::vector<LineLattice>& lattices, const std::vector<AccessPointBins>& access_points,
       const std::vector<Mask>& driven, const std::atomic<bool>& stop);

  const Unknowns& unknowns() const { return unknowns_; }

  /// Number of rays: all bins of the first access point, then those of the next.
  std::size_t size() const { return size_; }

  /// Sums `x` over the unknowns that each ray crosses.
  /// @param sums  set to one value for each ray
  void along(const Eigen::VectorXf& x, Eigen::VectorXf& sums) const { along_.of(x, sums); }

  /// Sums `values` over the rays that cross each unknown.
  /// @param sums  set to one value for each unknown
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
void Unknowns::forEachSlot(Visitor&& visit) const {
  auto block = blocks_.begin();
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    while (slots_[i] >= block->end) {
      ++block;
    }
    visit(i, *block, slots_[i] - block->first);
  }
}

template <class Visitor>
void Unknowns::forEach(Visitor&& visit) const {
  forEachSlot([&](std::size_t i, const Block& block, std::int64_t offset) {
    const std::int64_t line = offset / block.along;
    const std::int64_t along = offset % block.along;
    visit(static_cast<Eigen::Index>(i), block.direction,
          block.direction.walls_along_y ? Cell{line, along} : Cell{along, line});
  });
}

}  // namespace sfw
