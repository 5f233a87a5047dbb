#pragma once

#include <octomap/OcTree.h>

#include <cstdint>
#include <memory>

#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// A stack of equal voxels that starts at the floor.
struct Column {
  std::int32_t layers = 0;  ///< 0: no voxel, unknown
  float log_odds = 0.0F;
};

/// Builds the pruned tree with a column of voxels on each cell. It builds from the root down, so
/// equal voxels are merged from the start.
///
/// @param columns  their resolution is the tree's
/// @param first    voxel of the first cell, from the map's origin; all lie within kOctomapReach of
/// it O(cells + nodes).
std::unique_ptr<octomap::OcTree> treeOfColumns(const Grid<Column>& columns, Cell first);

/// Copies a tree with every voxel made certain, so that more neighbours merge.
/// O(nodes x levels).
std::unique_ptr<octomap::OcTree> mostLikely(const octomap::OcTree& tree);

}  // namespace sfw
