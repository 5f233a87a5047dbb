#include "structure_from_wifi/octomap_export.h"

#include <octomap/OcTree.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace sfw {
namespace {

constexpr std::int64_t kOctomapReach = 32768;

/// Voxels from the floor up that a height takes, at least one.
std::int64_t layers(double height_m, double resolution_m) {
  return std::max<std::int64_t>(1, std::llround(height_m / resolution_m));
}

template <class Write>
std::string encoded(Write&& write) {
  std::ostringstream stream;
  if (!write(stream) || !stream) {
    throw std::runtime_error("OctoMap could not encode its tree");
  }
  return stream.str();
}

/// The header that OctoMap's readers expect; its own writers print to the terminal.
std::string fileHeader(const char* magic, const octomap::OcTree& tree) {
  std::ostringstream header;
  header << magic << "\nid " << tree.getTreeType() << "\nsize " << tree.size() << "\nres "
         << tree.getResolution() << "\ndata\n";
  return header.str();
}

/// The tree with each voxel certain, so that equal neighbours merge.
octomap::OcTree mostLikely(const octomap::OcTree& tree) {
  octomap::OcTree copy(tree);
  copy.toMaxLikelihood();
  copy.prune();
  return copy;
}

}  // namespace

std::unique_ptr<octomap::OcTree> toOctomap(const BeliefMap& belief, const Config::Octomap& config) {
  const GridGeometry& geometry = belief.geometry();
  const double resolution = geometry.resolution();
  const Cell first{std::llround(geometry.origin().x() / resolution),
                   std::llround(geometry.origin().y() / resolution)};
  const std::int64_t wall_layers = layers(config.wall_height, resolution);
  const std::int64_t robot_layers = layers(config.robot_height, resolution);
  if (std::min(first.x, first.y) < -kOctomapReach ||
      std::max(first.x + geometry.width(), first.y + geometry.height()) > kOctomapReach ||
      std::max(wall_layers, robot_layers) > kOctomapReach) {
    throw std::invalid_argument("the map reaches beyond OctoMap's 32768 voxels from its origin");
  }
  auto tree = std::make_unique<octomap::OcTree>(resolution);
  // OctoMap's own limits would round our certain cells towards doubt.
  tree->setClampingThresMin(1e-4);
  tree->setClampingThresMax(1.0 - 1e-4);
  Cell c;
  for (c.y = 0; c.y < geometry.height(); ++c.y) {
    for (c.x = 0; c.x < geometry.width(); ++c.x) {
      const CellState state = belief.state(c);
      if (state == CellState::kUnknown) {
        continue;
      }
      // OctoMap knows no thresholds: its voxels are occupied from a half on, ours by their state.
      constexpr float kLeast = 1.0F / 16.0F;  // a step of BeliefMap
      const float believed = octomap::logodds(belief.occupied(c));
      const float log_odds =
          state == CellState::kOccupied ? std::max(believed, kLeast) : std::min(believed, -kLeast);
      const std::int64_t count = state == CellState::kOccupied ? wall_layers : robot_layers;
      for (std::int64_t z = 0; z < count; ++z) {
        const octomap::OcTreeKey key(static_cast<octomap::key_type>(first.x + c.x + kOctomapReach),
                                     static_cast<octomap::key_type>(first.y + c.y + kOctomapReach),
                                     static_cast<octomap::key_type>(z + kOctomapReach));
        tree->setNodeValue(key, log_odds, /*lazy_eval=*/true);
      }
    }
  }
  tree->updateInnerOccupancy();
  tree->prune();
  return tree;
}

std::string encodeBinaryFile(const octomap::OcTree& tree) {
  const octomap::OcTree binary = mostLikely(tree);
  return fileHeader("# Octomap OcTree binary file", binary) +
         encoded([&](std::ostream& stream) { return binary.writeBinaryData(stream).good(); });
}

std::string encodeFullFile(const octomap::OcTree& tree) {
  return fileHeader("# Octomap OcTree file", tree) + encodeFullMessage(tree);
}

std::string encodeBinaryMessage(const octomap::OcTree& tree) {
  const octomap::OcTree binary = mostLikely(tree);
  return encoded([&](std::ostream& stream) { return binary.writeBinaryData(stream).good(); });
}

std::string encodeFullMessage(const octomap::OcTree& tree) {
  return encoded([&](std::ostream& stream) { return tree.writeData(stream).good(); });
}

}  // namespace sfw
