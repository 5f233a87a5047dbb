#pragma once

#include <Eigen/Core>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tomography/line_field.h"
#include "tomography/sparse_sums.h"

namespace sfw {

/// The unknowns: pieces of wall that some ray crosses and that stand where no robot was.
///
/// Numbered wall line by wall line, so what continues a piece has the next number, and nothing that
/// is done to neighbours along a wall has to look them up.
class Unknowns {
 public:
  /// One of the directions that walls may have.
  struct Direction {
    std::size_t lattice;  ///< which
    bool across_x;        ///< walls along the lattice's y axis, otherwise along x
  };

  explicit Unknowns(const std::vector<LineLattice>& lattices);

  static constexpr std::int32_t kNone = -1;

  /// Place of a piece among all that the lattices could have, along its wall line.
  std::int32_t slot(const Direction& direction, Cell cell) const {
    const Block& block = blocks_[2 * direction.lattice + (direction.across_x ? 0 : 1)];
    return static_cast<std::int32_t>(block.first + (direction.across_x
                                                        ? cell.x * block.along + cell.y
                                                        : cell.y * block.along + cell.x));
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

  /// Calls `visit(number, Block, place in the block)` for each unknown, in their order.
  template <class Visitor>
  void forEachSlot(Visitor&& visit) const;

  std::vector<Block> blocks_;
  std::vector<std::int32_t> number_;  // by slot
  std::vector<std::int32_t> slots_;   // by number
};

/// All access points' rays, one after another, and the unknowns that each of them crosses.
class Rays {
 public:
  /// @param driven  for each lattice, the cells where no wall can stand
  /// @param stop    polled; when it turns true there are no unknowns
  Rays(const std::vector<LineLattice>& lattices, const std::vector<AccessPointBins>& heard,
       const std::vector<Mask>& driven, const std::atomic<bool>& stop);

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
  forEachSlot([&](std::size_t i, const Block& block, std::int64_t place) {
    const std::int64_t line = place / block.along;
    const std::int64_t along = place % block.along;
    visit(static_cast<Eigen::Index>(i), block.direction,
          block.direction.across_x ? Cell{line, along} : Cell{along, line});
  });
}

}  // namespace sfw
