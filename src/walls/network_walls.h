#pragma once

#include <atomic>
#include <vector>

#include "base/use_radio.h"
#include "belief/belief_model.h"
#include "belief/drive_features.h"
#include "walls/strip_walls.h"
#include "walls/wall_network.h"

namespace sfw {

/// Corrects the network's probability that a cell is occupied. The network is too sure of walls, so
/// probabilities above 0.55 become flatter (doc/method/network.md). Strictly increasing.
float calibratedOccupancy(float by_network);

/// What a network finds, on the grid of the features.
struct NetworkFindings {
  std::vector<StripWall> walls;
  Grid<float> free;  ///< probability of free space: the network's in open strips, else as given
  Grid<float>
      occupied;        ///< probability that a cell is a wall, if a lidar would see it from the path
  Grid<float> unseen;  ///< probability that a lidar would not see a cell from the path
};

/// Finds the walls beside the way of the robot with a network.
/// @param features  on cells of kNetworkCellM
/// @param style     share of the belief model for each driving style
/// @param free      probability of free space, with the same radio, as of freeProbability
/// @param free_above cells above this probability are free for the ends of walls
/// @param stop       polled; when it turns true the result is incomplete
/// O(cells x weights of the network).
NetworkFindings findWallsByNetwork(const DriveFeatures& features, const BeliefModel& model,
                                   const StyleShares& style, UseRadio use_radio,
                                   const Grid<float>& free, double free_above,
                                   const WallNetwork& network, const std::atomic<bool>& stop);

}  // namespace sfw
