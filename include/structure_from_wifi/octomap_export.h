#pragma once

#include <memory>
#include <string>

#include "structure_from_wifi/belief_map.h"
#include "structure_from_wifi/config.h"
#include "structure_from_wifi/export.h"

namespace octomap {
class OcTree;
}

namespace sfw {

/// Extrudes a map into voxels: occupied cells from the floor to octomap/wall_height, free cells
/// from the floor to octomap/robot_height, nothing where the map is unknown.
///
/// Each voxel keeps its cell's probability. The tree is pruned; its resolution is the map's, whose
/// origin lies on OctoMap's lattice by construction (GridGeometry::covering).
/// @throw std::invalid_argument unless octomapReaches the map, or if a height of the settings is
/// too large for OctoMap. O(known cells x height).
SFW_EXPORT std::unique_ptr<octomap::OcTree> toOctomap(const BeliefMap& belief,
                                                      const Config::Octomap& config);

/// Encodes the tree as a .bt file (occupied, free, unknown) or as an .ot file (log-odds).
SFW_EXPORT std::string encodeBinaryFile(const octomap::OcTree& tree);
SFW_EXPORT std::string encodeFullFile(const octomap::OcTree& tree);

/// Encodes the tree without the header of a file, as octomap_msgs/Octomap carries it.
SFW_EXPORT std::string encodeBinaryMessage(const octomap::OcTree& tree);
SFW_EXPORT std::string encodeFullMessage(const octomap::OcTree& tree);

}  // namespace sfw
