#pragma once

#include <octomap/OcTree.h>

#include <cstdint>
#include <memory>

#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// Voxels of one value from the floor up to a height.
struct Column {
  std::int32_t layers = 0;  ///< 0: no voxel, unknown
  float log_odds = 0.0F;
};

/// The tree that holds a column of voxels on each cell, pruned as OctoMap prunes. It is built from
/// the root down, so that voxels which merge are never made one by one.
///
/// @param columns  their resolution is the tree's
/// @param first    voxel of the first cell, from the map's origin; all lie within 32768 of it
/// O(cells + nodes).
std::unique_ptr<octomap::OcTree> treeOfColumns(const Grid<Column>& columns, Cell first);

/// A copy in which each voxel is certain, so that equal neighbours merge.
/// O(nodes x levels).
std::unique_ptr<octomap::OcTree> mostLikely(const octomap::OcTree& tree);

}  // namespace sfw
