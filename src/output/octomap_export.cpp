#include "structure_from_wifi/octomap_export.h"

#include <octomap/OcTree.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "grid/for_each_cell.h"
#include "output/octomap_columns.h"

namespace sfw {
namespace {

constexpr double kLeastCertain = 1e-4;  // probability that a certain voxel is wrong

/// The number of voxels from the floor to a height, at least one.
std::int32_t layers(double height_m, double resolution_m) {
  const double whole = std::round(height_m / resolution_m);
  return static_cast<std::int32_t>(std::clamp(whole, 1.0, kOctomapReach + 1.0));
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

}  // namespace

std::unique_ptr<octomap::OcTree> toOctomap(const BeliefMap& belief, const Config::Octomap& config) {
  const GridGeometry& geometry = belief.geometry();
  const double resolution = geometry.resolution();
  const std::int32_t wall_layers = layers(config.wall_height_m, resolution);
  const std::int32_t robot_layers = layers(config.robot_height_m, resolution);
  if (!octomapReaches(geometry)) {
    throw std::invalid_argument("the map reaches beyond OctoMap's 32768 voxels from its origin");
  }
  if (std::max(wall_layers, robot_layers) > kOctomapReach) {
    throw std::invalid_argument(
        "octomap/wall_height and octomap/robot_height must be at most 32768 cells");
  }
  Grid<Column> columns(geometry);
  forEachCell(geometry, [&](Cell c) {
    const CellState state = belief.state(c);
    if (state == CellState::kUnknown) {
      return;
    }
    // OctoMap has no thresholds. Its voxels are occupied from a half on; ours follow the state of
    // the cell.
    constexpr float kLeast = 1.0F / 16.0F;  // a step of BeliefMap
    const float log_odds =
        std::clamp(octomap::logodds(belief.occupied(c)), octomap::logodds(kLeastCertain),
                   octomap::logodds(1.0 - kLeastCertain));
    columns[c] = state == CellState::kOccupied ? Column{wall_layers, std::max(log_odds, kLeast)}
                                               : Column{robot_layers, std::min(log_odds, -kLeast)};
  });
  auto tree = treeOfColumns(columns, latticeCell(geometry));
  // OctoMap's own limits would make certain cells less certain.
  tree->setClampingThresMin(kLeastCertain);
  tree->setClampingThresMax(1.0 - kLeastCertain);
  return tree;
}

std::string encodeBinaryFile(const octomap::OcTree& tree) {
  const std::unique_ptr<octomap::OcTree> binary = mostLikely(tree);
  return fileHeader("# Octomap OcTree binary file", *binary) +
         encoded([&](std::ostream& stream) { return binary->writeBinaryData(stream).good(); });
}

std::string encodeFullFile(const octomap::OcTree& tree) {
  return fileHeader("# Octomap OcTree file", tree) + encodeFullMessage(tree);
}

std::string encodeBinaryMessage(const octomap::OcTree& tree) {
  const std::unique_ptr<octomap::OcTree> binary = mostLikely(tree);
  return encoded([&](std::ostream& stream) { return binary->writeBinaryData(stream).good(); });
}

std::string encodeFullMessage(const octomap::OcTree& tree) {
  return encoded([&](std::ostream& stream) { return tree.writeData(stream).good(); });
}

}  // namespace sfw
