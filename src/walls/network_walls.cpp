#include "walls/network_walls.h"

#include <algorithm>
#include <cmath>

#include "belief/free_probability.h"
#include "grid/distance_transform.h"
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

ModelProbabilities modelProbabilities(const CellFeatures& cells, const BeliefModel& model,
                                      const StyleShares& style, UseRadio use_radio) {
  return {singleProbabilities(cells, model, style, use_radio),
          freeProbability(cells, model, style, use_radio)};
}

}  // namespace

NetworkWalls findWallsByNetwork(const DriveFeatures& features, const BeliefModel& model,
                                const StyleShares& style, UseRadio use_radio,
                                const Grid<float>& free, double free_above,
                                const WallNetwork& network) {
  const CellFeatures& cells = features.cells;
  const ModelProbabilities by_path = modelProbabilities(cells, model, style, UseRadio::kNo);
  const ModelProbabilities by_all = modelProbabilities(cells, model, style, use_radio);
  const Channels output =
      network.apply(networkInputs(features, features.path, by_all, by_path, use_radio));
  const Grid<double> distance = distanceTransform(features.path.cells);
  NetworkWalls result{Grid<float>(cells.geometry), {}};
  Mask footprint(cells.geometry);
  Mask is_free(cells.geometry);
  const float* density = output.row(WallNetwork::kDensity, 0);
  for (const std::size_t i : cells.cells) {
    const bool covered =
        distance.cells[i] * cells.geometry.resolution() <= features.path.robot_radius_m;
    footprint.cells[i] = covered ? 1 : 0;
    is_free.cells[i] = covered || free.cells[i] > free_above ? 1 : 0;
    result.density.cells[i] = covered ? 0.0F : softplus(density[i]);
  }
  result.walls = findStripWalls(footprint, result.density, is_free, {});
  return result;
}

}  // namespace sfw
