#pragma once

#include <gtest/gtest.h>
#include <nav_msgs/OccupancyGrid.h>
#include <octomap/OcTree.h>
#include <octomap_msgs/Octomap.h>

#include <cmath>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <utility>

namespace sfw {

/// Reads octomap_msgs/Octomap as octomap_msgs' own conversions do (octomap_server and rviz use
/// those), and compares the tree with a grid. Faults become gtest failures.
class OctomapReader {
 public:
  using Columns = std::set<std::pair<long, long>>;  // cells from the map frame's origin

  /// The tree of a message, or nullptr.
  static std::unique_ptr<octomap::OcTree> read(const octomap_msgs::Octomap& message) {
    EXPECT_EQ(message.id, "OcTree");
    EXPECT_GT(message.resolution, 0.0);
    if (message.id != "OcTree" || !(message.resolution > 0.0)) {
      return nullptr;
    }
    auto tree = std::make_unique<octomap::OcTree>(message.resolution);
    std::stringstream data(std::string(message.data.begin(), message.data.end()));
    // The tree of an empty map has no bytes; octomap's readers need at least one.
    if (!message.data.empty()) {
      const bool good = message.binary != 0 ? static_cast<bool>(tree->readBinaryData(data))
                                            : static_cast<bool>(tree->readData(data));
      EXPECT_TRUE(good || data.eof()) << "octomap cannot read the data";
      EXPECT_EQ(data.peek(), std::char_traits<char>::eof()) << "bytes are left over";
    }
    return tree;
  }

  /// Expects that the tree's columns are the grid's occupied and free cells, each layer alike.
  static void expectSame(const octomap::OcTree& tree, const nav_msgs::OccupancyGrid& grid) {
    EXPECT_NEAR(tree.getResolution(), static_cast<double>(grid.info.resolution), 1e-7);
    const std::pair<Columns, Columns> floor = columnsAt(tree, 0);
    const std::pair<Columns, Columns> cells = cellsOf(grid);
    EXPECT_EQ(floor.first, cells.first) << "occupied cells differ";
    EXPECT_EQ(floor.second, cells.second) << "free cells differ";
  }

  /// Occupied and free voxels of one layer above the floor.
  static std::pair<Columns, Columns> columnsAt(const octomap::OcTree& tree, int layer) {
    std::pair<Columns, Columns> columns;
    const double resolution = tree.getResolution();
    for (auto leaf = tree.begin_leafs(), end = tree.end_leafs(); leaf != end; ++leaf) {
      const long span = std::lround(leaf.getSize() / resolution);
      const auto first = [&](double centre) {
        return std::lround((centre - 0.5 * leaf.getSize()) / resolution);
      };
      const long z = first(leaf.getZ());
      if (layer < z || layer >= z + span) {
        continue;
      }
      Columns& into = tree.isNodeOccupied(*leaf) ? columns.first : columns.second;
      for (long x = 0; x < span; ++x) {
        for (long y = 0; y < span; ++y) {
          into.emplace(first(leaf.getX()) + x, first(leaf.getY()) + y);
        }
      }
    }
    return columns;
  }

 private:
  static std::pair<Columns, Columns> cellsOf(const nav_msgs::OccupancyGrid& grid) {
    std::pair<Columns, Columns> cells;
    const auto resolution = static_cast<double>(grid.info.resolution);
    const long first_x = std::lround(grid.info.origin.position.x / resolution);
    const long first_y = std::lround(grid.info.origin.position.y / resolution);
    for (std::size_t i = 0; i < grid.data.size(); ++i) {
      const std::pair<long, long> at(first_x + static_cast<long>(i % grid.info.width),
                                     first_y + static_cast<long>(i / grid.info.width));
      if (grid.data[i] == 100) {
        cells.first.insert(at);
      } else if (grid.data[i] == 0) {
        cells.second.insert(at);
      }
    }
    return cells;
  }
};

}  // namespace sfw
