#include "belief/cell_features.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "support/feature_scene.h"

namespace sfw::test {
namespace {

bool usesRadio(const std::string& name) {
  for (const CellFeature& feature : kCellFeatureTable) {
    if (feature.name == name) {
      return feature.uses_radio;
    }
  }
  throw std::invalid_argument(name);
}

TEST(CellFeatures, HaveANameEach) {
  std::set<std::string> names;
  for (const CellFeature& feature : kCellFeatureTable) {
    names.insert(feature.name);
  }
  EXPECT_EQ(names.size(), kCellFeatures);
}

TEST(CellFeatures, UseTheRadioIfTheyChangeWithTheSignalsAlone) {
  // The same drive twice; walls and losses differ, as they would for other signals.
  const Picture path{"#######", ".......", "......."};
  FeatureScene scene{path, 0.2, Picture(3, "0000000")};
  scene.access_points = {accessPointAt(scene, {0, 1}, std::vector<Cell>(12, {6, 1}))};
  scene.ray_loss_db = {std::vector<double>(12, 0.0)};
  const CellFeatures before = described(scene);
  scene.wall_db = Picture(3, "3333333");
  scene.ray_loss_db = {{9, 8, 7, 6, 5, 4, 3, 2, 2, 2, 2, 2}};
  const ExplainedVarianceLimits limits{0.5, 0.7};
  const CellFeatures after = described(scene, limits);
  for (const CellFeature& feature : kCellFeatureTable) {
    EXPECT_EQ(featureOf(before, feature.name).cells != featureOf(after, feature.name).cells,
              feature.uses_radio)
        << feature.name;
  }
}

TEST(CellFeatures, OfTheRadioAreAllThatWallLossesMake) {
  for (const char* name : {"line_of_sight", "wall_strength", "wall_beside", "way_around",
                           "explained", "explained_way_around", "way_around_over_0.25"}) {
    EXPECT_TRUE(usesRadio(name)) << name;
  }
  for (const char* name : {"path_distance", "rays", "access_points", "source_depth_2.4"}) {
    EXPECT_FALSE(usesRadio(name)) << name;
  }
}

}  // namespace
}  // namespace sfw::test
