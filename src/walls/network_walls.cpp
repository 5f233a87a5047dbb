#include "walls/network_walls.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "grid/robot_evidence.h"
#include "walls/network_inputs.h"

namespace sfw {
namespace {

/// ln(1 + e^x), without overflow.
float softplus(float x) { return std::max(x, 0.0F) + std::log1p(std::exp(-std::abs(x))); }

/// The network's probabilities of the states of a cell; they sum to 1.
struct StateProbabilities {
  float free, wall, unseen;
};

/// The belief model's log odds count half, as in the network's training.
StateProbabilities statesByNetwork(const Channels& output, std::size_t cell, float free_by_model) {
  const auto logit = [&](WallNetwork::Output channel) { return output.row(channel, 0)[cell]; };
  const float free = logit(WallNetwork::kFree) + 0.5F * limitedLogOdds(free_by_model);
  const float wall = std::exp(logit(WallNetwork::kWall) - free);
  const float unseen = std::exp(logit(WallNetwork::kUnseen) - free);
  const float sum = 1.0F + wall + unseen;
  return {1.0F / sum, wall / sum, unseen / sum};
}

}  // namespace

float calibratedOccupancy(float by_network) {
  constexpr float kKnee = 0.55F;
  constexpr float kSlope = 0.1F;  // keeps the order of cells
  return std::min(by_network, kKnee + kSlope * std::max(by_network - kKnee, 0.0F));
}

NetworkFindings findWallsByNetwork(const DriveFeatures& features, const BeliefModel& model,
                                   const StyleShares& style, UseRadio use_radio,
                                   const Grid<float>& free, double free_above,
                                   const WallNetwork& network, const std::atomic<bool>& stop) {
  const CellFeatures& cells = features.cells;
  const Mask footprint = footprintOf(features.path);
  const Channels output =
      network.apply(networkInputs(features, footprint, model, style, use_radio, free), stop);
  Grid<float> density(cells.geometry);
  Mask is_free = footprint;
  for (const std::size_t i : cells.cells) {
    if (footprint.cells[i] == 0) {
      is_free.cells[i] = free.cells[i] > free_above ? 1 : 0;
      density.cells[i] = softplus(output.row(WallNetwork::kDensity, 0)[i]);
    }
  }
  StripFindings strips = findStripWalls(footprint, density, is_free, {});
  NetworkFindings findings{std::move(strips.walls), free,
                           Grid<float>(cells.geometry, kUnknownOccupancy),
                           Grid<float>(cells.geometry, 1.0F)};
  for (const std::size_t i : cells.cells) {
    const StateProbabilities states = statesByNetwork(output, i, free.cells[i]);
    findings.occupied.cells[i] = calibratedOccupancy(states.wall / (states.wall + states.free));
    findings.unseen.cells[i] = states.unseen;
    if (strips.open.cells[i] != 0) {
      findings.free.cells[i] = std::max(free.cells[i], states.free);
    }
  }
  return findings;
}

}  // namespace sfw
