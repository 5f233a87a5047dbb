#include "structure_from_wifi/octomap_export.h"

#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <algorithm>
#include <memory>
#include <sstream>

#include "grid/for_each_cell.h"
#include "support/ascii_world.h"

namespace sfw {
namespace {

using Rows = std::vector<std::string>;

const Rows kPicture{".#?..##",  //
                    "#???.##",  //
                    "...##..",  //
                    "...##.?"};

BeliefMap beliefOf(const Rows& rows, const Position& origin = Position(-0.8, 1.6),
                   const Config::Belief& thresholds = {}) {
  const auto probability = [](char c) { return c == '.' ? 0.1F : c == '#' ? 0.9F : 0.5F; };
  return {test::gridFrom<float>(rows, 0.1, probability, origin), thresholds};
}

std::unique_ptr<octomap::OcTree> readBinaryFile(const BeliefMap& belief,
                                                const Config::Octomap& config) {
  std::istringstream stream(encodeBinaryFile(*toOctomap(belief, config)));
  auto tree = std::make_unique<octomap::OcTree>(1.0);
  return tree->readBinary(stream) ? std::move(tree) : nullptr;
}

std::unique_ptr<octomap::OcTree> readFullFile(const BeliefMap& belief,
                                              const Config::Octomap& config) {
  std::istringstream stream(encodeFullFile(*toOctomap(belief, config)));
  octomap::AbstractOcTree* const read = octomap::AbstractOcTree::read(stream);
  return std::unique_ptr<octomap::OcTree>(dynamic_cast<octomap::OcTree*>(read));
}

/// The tree's layer at a height as a picture of the map's extent.
Rows layer(const octomap::OcTree& tree, const GridGeometry& geometry, double z) {
  Grid<CellState> states(geometry);
  forEachCell(geometry, [&](Cell c) {
    const Position centre = geometry.centre(c);
    const octomap::OcTreeNode* const node = tree.search(centre.x(), centre.y(), z);
    if (node != nullptr) {
      states[c] = tree.isNodeOccupied(node) ? CellState::kOccupied : CellState::kFree;
    }
  });
  return test::rowsOf(states);
}

/// The rows with only some of their states.
Rows only(char kept, Rows rows) {
  for (std::string& row : rows) {
    for (char& c : row) {
      c = c == kept ? c : '?';
    }
  }
  return rows;
}

/// Checks every layer from below the floor to above the walls.
void expectThePicture(const octomap::OcTree* tree, const BeliefMap& belief,
                      const Config::Octomap& config) {
  ASSERT_NE(tree, nullptr);
  EXPECT_NEAR(tree->getResolution(), 0.1, 1e-9);
  for (int level = -2; level < 30; ++level) {
    const double z = 0.1 * level + 0.05;
    Rows expected = only(' ', kPicture);
    if (z > 0.0 && z < config.robot_height_m) {
      expected = kPicture;
    } else if (z > 0.0 && z < config.wall_height_m) {
      expected = only('#', kPicture);
    }
    EXPECT_EQ(layer(*tree, belief.geometry(), z), expected) << "at a height of " << z;
  }
}

TEST(OctomapExport, FillsWallsAndTheRobotsHeight) {
  Config::Octomap config;
  config.wall_height_m = 2.0;
  config.robot_height_m = 0.5;
  const BeliefMap belief = beliefOf(kPicture);
  expectThePicture(readBinaryFile(belief, config).get(), belief, config);
  expectThePicture(readFullFile(belief, config).get(), belief, config);
}

TEST(OctomapExport, LiesOnTheMapsLatticeAnywhere) {
  for (const Position& origin : {Position(0, 0), Position(-1600, 1600), Position(0.7, -0.3)}) {
    const BeliefMap belief = beliefOf(kPicture, origin);
    const auto tree = readFullFile(belief, {});
    ASSERT_NE(tree, nullptr);
    EXPECT_EQ(layer(*tree, belief.geometry(), 0.05), kPicture) << origin;
  }
}

TEST(OctomapExport, HasALayerHoweverLowTheRobot) {
  Config::Octomap config;
  config.wall_height_m = 0.001;
  config.robot_height_m = 0.001;
  const BeliefMap belief = beliefOf(kPicture);
  const auto tree = readBinaryFile(belief, config);
  ASSERT_NE(tree, nullptr);
  EXPECT_EQ(layer(*tree, belief.geometry(), 0.05), kPicture);
  EXPECT_EQ(layer(*tree, belief.geometry(), 0.15), only(' ', kPicture));
}

TEST(OctomapExport, KeepsProbabilitiesInTheFullTree) {
  const BeliefMap belief = beliefOf(kPicture);
  const auto tree = readFullFile(belief, {});
  ASSERT_NE(tree, nullptr);
  const Position wall = belief.geometry().centre({1, 3});
  const Position free = belief.geometry().centre({0, 3});
  EXPECT_NEAR(tree->search(wall.x(), wall.y(), 0.05)->getOccupancy(), belief.occupied({1, 3}),
              1e-4);
  EXPECT_NEAR(tree->search(free.x(), free.y(), 0.05)->getOccupancy(), belief.occupied({0, 3}),
              1e-4);
}

TEST(OctomapExport, FollowsTheMapsThresholdsNotItsOwn) {
  Config::Belief thresholds;
  thresholds.free_threshold = 0.92;  // even '#' is free
  thresholds.occupied_threshold = 0.95;
  const BeliefMap all_free = beliefOf(kPicture, {0, 0}, thresholds);
  Rows expected = kPicture;
  for (std::string& row : expected) {
    std::replace(row.begin(), row.end(), '#', '.');
  }
  EXPECT_EQ(layer(*readBinaryFile(all_free, {}), all_free.geometry(), 0.05), expected);
  EXPECT_EQ(layer(*readFullFile(all_free, {}), all_free.geometry(), 0.05), expected);
}

TEST(OctomapExport, MakesAnEmptyTreeOfAnUnknownMap) {
  const BeliefMap belief(GridGeometry(0.05, {0, 0}, 10, 10), {});
  const auto binary = readBinaryFile(belief, {});
  const auto full = readFullFile(belief, {});
  ASSERT_NE(binary, nullptr);
  ASSERT_NE(full, nullptr);
  EXPECT_EQ(binary->getNumLeafNodes(), 0U);
  EXPECT_EQ(full->getNumLeafNodes(), 0U);
}

TEST(OctomapExport, CarriesTheSameDataInMessages) {
  const BeliefMap belief = beliefOf(kPicture);
  const auto tree = toOctomap(belief, {});
  octomap::OcTree binary(0.1);
  std::istringstream binary_data(encodeBinaryMessage(*tree));
  binary.readBinaryData(binary_data);
  EXPECT_EQ(layer(binary, belief.geometry(), 0.05), kPicture);
  octomap::OcTree full(0.1);
  std::istringstream full_data(encodeFullMessage(*tree));
  full.readData(full_data);
  EXPECT_EQ(layer(full, belief.geometry(), 0.05), kPicture);
}

TEST(OctomapExport, RefusesAMapBeyondOctomapsReach) {
  EXPECT_THROW(toOctomap(beliefOf(kPicture, {3276.8, 0.0}), {}), std::invalid_argument);
  EXPECT_THROW(toOctomap(beliefOf(kPicture, {0.0, -3276.9}), {}), std::invalid_argument);
  EXPECT_NO_THROW(toOctomap(beliefOf(kPicture, {3276.1, -3276.8}), {}));
  Config::Octomap tall;
  tall.wall_height_m = 1e12;
  EXPECT_THROW(toOctomap(beliefOf(kPicture), tall), std::invalid_argument);
}

}  // namespace
}  // namespace sfw
