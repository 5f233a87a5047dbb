#include "walls/network_walls.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/log_odds.h"
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

/// The network's probability of free space in a cell. The belief model's log odds count half, as in
/// the network's training.
float freeByNetwork(const Channels& output, std::size_t cell, float free_by_model) {
  const auto logit = [&](WallNetwork::Output channel) { return output.row(channel, 0)[cell]; };
  const float free = logit(WallNetwork::kFree) + 0.5F * limitedLogOdds(free_by_model);
  return 1.0F / (1.0F + std::exp(logit(WallNetwork::kWall) - free) +
                 std::exp(logit(WallNetwork::kUnseen) - free));
}

}  // namespace

NetworkFindings findWallsByNetwork(const DriveFeatures& features, const BeliefModel& model,
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
  Grid<float> density(cells.geometry);
  Mask is_free = footprint;
  for (const std::size_t i : cells.cells) {
    if (footprint.cells[i] == 0) {
      is_free.cells[i] = free.cells[i] > free_above ? 1 : 0;
      density.cells[i] = softplus(output.row(WallNetwork::kDensity, 0)[i]);
    }
  }
  StripFindings strips = findStripWalls(footprint, density, is_free, {});
  NetworkFindings findings{std::move(strips.walls), free};
  for (const std::size_t i : cells.cells) {
    if (strips.open.cells[i] != 0) {
      findings.free.cells[i] = std::max(free.cells[i], freeByNetwork(output, i, free.cells[i]));
    }
  }
  return findings;
}

}  // namespace sfw
