#include "belief/cell_features.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace sfw {
namespace {

std::size_t numberOf(const std::string& name) {
  const auto& names = cellFeatureNames();
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

TEST(CellFeatures, HaveANameEach) {
  const auto& names = cellFeatureNames();
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), kCellFeatures);
}

TEST(CellFeatures, OfTheRadioAreAllThatWallLossesMake) {
  for (const char* name : {"line_of_sight", "wall_strength", "wall_beside", "way_around",
                           "explained", "explained_way_around", "way_around_over_0.25"}) {
    EXPECT_TRUE(usesRadio(numberOf(name))) << name;
  }
  for (const char* name : {"path_distance", "rays", "access_points", "source_depth_2.4"}) {
    EXPECT_FALSE(usesRadio(numberOf(name))) << name;
  }
}

CellFeatures oneCell(double explained) {
  CellFeatures features{GridGeometry(0.1, {0.0, 0.0}, 1, 1), {0}, {{}}, {}, explained};
  auto& cell = features.values.front();
  cell[numberOf("path_distance")] = 2.0F;
  cell[numberOf("explained")] = static_cast<float>(explained);
  for (const std::string name : {"line_of_sight", "wall_strength", "wall_beside", "way_around"}) {
    cell[numberOf(name)] = 0.5F;
    cell[numberOf("explained_" + name)] = 0.5F * static_cast<float>(explained);
  }
  return features;
}

TEST(CellFeatures, CutExplainedGivesTheCellsOfADriveAtTheLimit) {
  CellFeatures features = oneCell(0.9);
  clampExplainedVariance(0.4, 0.75, features);
  EXPECT_EQ(features.explained, 0.75);
  EXPECT_EQ(features.values, oneCell(0.75).values);
  features = oneCell(0.5);
  clampExplainedVariance(0.4, 0.75, features);
  EXPECT_EQ(features.values, oneCell(0.5).values);
  features = oneCell(0.0);
  clampExplainedVariance(0.5, 0.75, features);
  EXPECT_EQ(features.values, oneCell(0.5).values);
}

}  // namespace
}  // namespace sfw
