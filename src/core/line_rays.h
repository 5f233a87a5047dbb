#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "structure_from_wifi/line_field.h"

namespace sfw {

/// The direction that rays cross a wall in.
enum class Direction { kAcrossX, kAcrossY };

/// The unknowns: cells that some ray crosses and no robot has covered, in both directions.
class Unknowns {
 public:
  Unknowns(const GridGeometry& geometry, const Mask& driven)
      : geometry_(geometry),
        driven_(driven),
        id_{Grid<std::int32_t>(geometry, kNone), Grid<std::int32_t>(geometry, kNone)} {}

  static constexpr std::int32_t kNone = -1;

  /// The unknown of a cell of the grid, made if need be; kNone if the robot was there.
  std::int32_t at(Direction direction, Cell cell) {
    if (driven_[cell] != 0) {
      return kNone;
    }
    std::int32_t& id = ids(direction)[cell];
    if (id == kNone) {
      id = static_cast<std::int32_t>(cells_.size());
      cells_.push_back({direction, cell});
    }
    return id;
  }

  std::int32_t find(Direction direction, Cell cell) const {
    return geometry_.contains(cell) ? ids(direction)[cell] : kNone;
  }

  struct Place {
    Direction direction;
    Cell cell;
  };
  const std::vector<Place>& cells() const { return cells_; }

  /// The next cell along the wall that an unknown is part of.
  static Cell along(const Place& place, std::int64_t step) {
    return place.direction == Direction::kAcrossX ? Cell{place.cell.x, place.cell.y + step}
                                                  : Cell{place.cell.x + step, place.cell.y};
  }
  static Cell across(const Place& place, std::int64_t step) {
    return place.direction == Direction::kAcrossX ? Cell{place.cell.x + step, place.cell.y}
                                                  : Cell{place.cell.x, place.cell.y + step};
  }

 private:
  Grid<std::int32_t>& ids(Direction direction) { return id_[static_cast<std::size_t>(direction)]; }
  const Grid<std::int32_t>& ids(Direction direction) const {
    return id_[static_cast<std::size_t>(direction)];
  }

  const GridGeometry& geometry_;
  const Mask& driven_;
  Grid<std::int32_t> id_[2];
  std::vector<Place> cells_;
};

/// One access point's rays: the unknowns that each crosses, and what is heard at its end.
class Rays {
 public:
  /// Makes the unknowns that its rays cross.
  Rays(const GridGeometry& geometry, const HeardAccessPoint& heard, const ShadowingModel& model,
       Unknowns& unknowns);

  const SignalPrecision& precision() const { return precision_; }

  /// Signals less those that would be expected without walls [dB].
  const Eigen::VectorXd& unexplained() const { return unexplained_; }

  /// Sum of `x` over the cells that each ray crosses.
  Eigen::VectorXd along(const Eigen::VectorXf& x) const;

  /// Adds each ray's value to the cells that it crosses.
  void spread(const Eigen::VectorXd& values, Eigen::VectorXf& sums) const;

 private:
  std::size_t size() const { return begin_.size() - 1; }

  std::vector<std::size_t> begin_;     // of each ray in `crossed_`, and the end
  std::vector<std::int32_t> crossed_;  // unknowns
  SignalPrecision precision_;
  Eigen::VectorXd unexplained_;
};

}  // namespace sfw
