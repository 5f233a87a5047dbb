#include "walls/network_walls.h"

#include <algorithm>
#include <cmath>

#include "walls/network_inputs.h"

namespace sfw {
namespace {

/// ln(1 + e^x), without overflow.
float softplus(float x) { return std::max(x, 0.0F) + std::log1p(std::exp(-std::abs(x))); }

}  // namespace

std::vector<StripWall> findWallsByNetwork(const DriveFeatures& features, const BeliefModel& model,
                                          const StyleShares& style, UseRadio use_radio,
                                          const Grid<float>& free, double free_above,
                                          const WallNetwork& network) {
  const CellFeatures& cells = features.cells;
  const Mask footprint = footprintOf(features.path);
  const Channels output =
      network.apply(networkInputs(features, footprint, model, style, use_radio, free));
  const float* density_before_softplus = output.row(WallNetwork::kDensity, 0);
  Grid<float> density(cells.geometry);
  Mask is_free = footprint;
  for (const std::size_t i : cells.cells) {
    if (footprint.cells[i] == 0) {
      is_free.cells[i] = free.cells[i] > free_above ? 1 : 0;
      density.cells[i] = softplus(density_before_softplus[i]);
    }
  }
  return findStripWalls(footprint, density, is_free, {});
}

}  // namespace sfw
