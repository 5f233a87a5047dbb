#include "structure_from_wifi/belief_map.h"

#include <mrpt/maps/CLogOddsGridMapLUT.h>

#include <mutex>
#include <stdexcept>
#include <utility>

#include "files/mrpt_library.h"

namespace sfw {
namespace {

using MrptTables = mrpt::maps::CLogOddsGridMapLUT<std::int8_t>;

/// MRPT's own tables, which its headers make without its libraries.
MrptTables& tables() {
  static MrptTables tables;
  return tables;
}

std::vector<std::int8_t> logOddsOf(const Grid<float>& occupied) {
  MrptTables& mrpt = tables();
  std::vector<std::int8_t> log_odds;
  log_odds.reserve(occupied.cells.size());
  for (const float p : occupied.cells) {
    // MRPT reads outside its tables for any other number, NaN included.
    const bool valid = p >= 0.0F && p <= 1.0F;
    log_odds.push_back(mrpt.p2l(valid ? 1.0F - p : 0.5F));
  }
  return log_odds;
}

CellBelief beliefOf(std::int8_t log_odds, const Config::Belief& config) {
  const float p = 1.0F - tables().l2p(log_odds);
  const bool known = log_odds != 0;
  CellState state = CellState::kUnknown;
  if (known && p < config.free_threshold) {
    state = CellState::kFree;
  } else if (known && p > config.occupied_threshold) {
    state = CellState::kOccupied;
  }
  return {p, known, state};
}

}  // namespace

/// MRPT's grid, at the place where the map was made.
struct BeliefMap::MrptGrid {
  explicit MrptGrid(const GridGeometry& of) : geometry(of) {}

  GridGeometry geometry;
  std::once_flag first_use;
  std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> grid;
};

BeliefMap::BeliefMap(const GridGeometry& geometry, const Config::Belief& config,
                     std::vector<std::int8_t> log_odds)
    : geometry_(geometry),
      log_odds_(std::make_shared<const std::vector<std::int8_t>>(std::move(log_odds))),
      mrpt_grid_(std::make_shared<MrptGrid>(geometry)) {
  if (geometry.origin().cwiseAbs().maxCoeff() / geometry.resolution() >
      GridGeometry::kFarthestMap) {
    throw std::invalid_argument("geometry is too far from the origin");
  }
  for (std::size_t i = 0; i < kValues; ++i) {
    values_[i] = beliefOf(static_cast<std::int8_t>(i), config);
  }
}

BeliefMap::BeliefMap(const GridGeometry& geometry, const Config::Belief& config)
    : BeliefMap(geometry, config, std::vector<std::int8_t>(geometry.size(), tables().p2l(0.5F))) {}

BeliefMap::BeliefMap(const Grid<float>& occupied, const Config::Belief& config)
    : BeliefMap(occupied.geometry, config, logOddsOf(occupied)) {}

BeliefMap BeliefMap::moved(const Position& by) const {
  BeliefMap result = *this;
  result.geometry_ = GridGeometry(geometry_.resolution(), geometry_.origin() + by,
                                  geometry_.width(), geometry_.height());
  return result;
}

const mrpt::maps::COccupancyGridMap2D& BeliefMap::grid() const {
  MrptGrid& mrpt = *mrpt_grid_;
  std::call_once(mrpt.first_use, [&] {
    const GridGeometry& made = mrpt.geometry;
    mrpt.grid = mrptFunctions().toGrid(made.box(), made.resolution(), made.width(), made.height(),
                                       *log_odds_);
  });
  return *mrpt.grid;
}

}  // namespace sfw
