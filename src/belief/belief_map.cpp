#include "structure_from_wifi/belief_map.h"

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <stdexcept>

namespace sfw {
namespace {

using MrptGrid = mrpt::maps::COccupancyGridMap2D;

std::shared_ptr<MrptGrid> emptyGrid(const GridGeometry& geometry) {
  const Box box = geometry.box();
  const char* const too_far = "geometry is too large or too far from the origin for MRPT";
  if (geometry.origin().cwiseAbs().maxCoeff() / geometry.resolution() >
      GridGeometry::kFarthestMap) {
    throw std::invalid_argument(too_far);  // otherwise MRPT fails later, or not at all
  }
  auto grid = std::make_shared<MrptGrid>(
      static_cast<float>(box.min().x()), static_cast<float>(box.max().x()),
      static_cast<float>(box.min().y()), static_cast<float>(box.max().y()),
      static_cast<float>(geometry.resolution()));
  // MRPT calculates the size from extents in float. It must equal our size.
  if (grid->getSizeX() != geometry.width() || grid->getSizeY() != geometry.height()) {
    throw std::invalid_argument(too_far);
  }
  grid->fill(0.5F);
  return grid;
}

std::shared_ptr<MrptGrid> gridOf(const Grid<float>& occupied) {
  const GridGeometry& geometry = occupied.geometry;
  std::shared_ptr<MrptGrid> grid = emptyGrid(geometry);
  for (std::int64_t y = 0; y < geometry.height(); ++y) {
    MrptGrid::cellType* row = grid->getRow(static_cast<int>(y));
    for (std::int64_t x = 0; x < geometry.width(); ++x) {
      const float p = occupied[Cell{x, y}];
      // MRPT stores the probability of free space. It reads outside its tables for any other
      // number, NaN included.
      const bool valid = p >= 0.0F && p <= 1.0F;
      row[x] = MrptGrid::p2l(valid ? 1.0F - p : 0.5F);
    }
  }
  return grid;
}

}  // namespace

BeliefMap::BeliefMap(const GridGeometry& geometry, const Config::Belief& config)
    : geometry_(geometry), config_(config), grid_(emptyGrid(geometry)) {}

BeliefMap::BeliefMap(const Grid<float>& occupied, const Config::Belief& config)
    : geometry_(occupied.geometry), config_(config), grid_(gridOf(occupied)) {}

BeliefMap BeliefMap::moved(const Position& by) const {
  BeliefMap result = *this;
  result.geometry_ = GridGeometry(geometry_.resolution(), geometry_.origin() + by,
                                  geometry_.width(), geometry_.height());
  return result;
}

float BeliefMap::occupied(Cell c) const {
  return 1.0F - grid_->getCell(static_cast<int>(c.x), static_cast<int>(c.y));
}

bool BeliefMap::known(Cell c) const { return grid_->getRow(static_cast<int>(c.y))[c.x] != 0; }

CellState BeliefMap::state(Cell c) const {
  if (!known(c)) {
    return CellState::kUnknown;
  }
  const float p = occupied(c);
  if (p < config_.free_threshold) {
    return CellState::kFree;
  }
  return p > config_.occupied_threshold ? CellState::kOccupied : CellState::kUnknown;
}

}  // namespace sfw
