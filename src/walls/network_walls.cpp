#include "walls/network_walls.h"

#include <algorithm>
#include <cmath>

#include "belief/free_probability.h"
#include "grid/morphology.h"
#include "grid/robot_evidence.h"
#include "walls/network_inputs.h"

namespace sfw {
namespace {

/// ln(1 + e^x), without overflow.
float softplus(float x) { return std::max(x, 0.0F) + std::log1p(std::exp(-std::abs(x))); }

/// The belief model's probability of each cell by itself.
Grid<float> singleProbabilities(const CellFeatures& cells, const BeliefModel& model,
                                const StyleShares& style, UseRadio use_radio) {
  Grid<float> free(cells.geometry, kUnknownOccupancy);
  for (std::size_t i = 0; i < cells.cells.size(); ++i) {
    free.cells[cells.cells[i]] = static_cast<float>(model.free(cells.values[i], style, use_radio));
  }
  return free;
}

}  // namespace

std::vector<StripWall> findWallsByNetwork(const DriveFeatures& features, const BeliefModel& model,
                                          const StyleShares& style, UseRadio use_radio,
                                          const Grid<float>& free, double free_above,
                                          const WallNetwork& network) {
  const CellFeatures& cells = features.cells;
  const DrivenPath& path = features.path;
  const Mask footprint = dilated(path.cells, path.robot_radius_m / cells.geometry.resolution());
  const ModelProbabilities by_path{singleProbabilities(cells, model, style, UseRadio::kNo),
                                   freeProbability(cells, model, style, UseRadio::kNo)};
  const ModelProbabilities by_all{singleProbabilities(cells, model, style, use_radio), free};
  const Channels output =
      network.apply(networkInputs(features, footprint, by_all, by_path, use_radio));
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
