#include "training/belief_training.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "base/random.h"

namespace sfw::test {
namespace {

const PathStyle kWallFollower{0.5, 0.5, 0.05};
const PathStyle kPatrolling{0.9, 0.5, 0.05};
const PathStyle kStrolling{0.1, 0.5, 0.3};

PathStyle near(const PathStyle& style, Random& random) {
  return {style.rim_share + 0.1 * random.normal(), style.axis_share + 0.1 * random.normal(),
          style.winding + 0.01 * random.normal()};
}

/// Cells that are free by a logistic law with `weight` on feature 1 and -1 on feature 12.
TrainingCells drawn(DrivingStyle made, const PathStyle& style, double weight, std::size_t count,
                    Random& random) {
  TrainingCells drive{made, style, {}, {}};
  for (std::size_t i = 0; i < count; ++i) {
    FeatureVector cell{};
    for (float& value : cell) {
      value = static_cast<float>(random.normal());
    }
    const double score =
        0.5 + weight * static_cast<double>(cell[1]) - static_cast<double>(cell[13]);
    drive.cells.push_back(cell);
    drive.free.push_back(random.uniform() < 1.0 / (1.0 + std::exp(-score)) ? 1 : 0);
  }
  return drive;
}

TEST(BeliefTraining, FindsTheWeightsThatMadeTheCells) {
  Random random(1, 1, 1);
  std::vector<TrainingCells> drives;
  for (int i = 0; i < 20; ++i) {
    drives.push_back(
        drawn(DrivingStyle::kAlongWalls, near(kWallFollower, random), 1.5, 2000, random));
    drives.push_back(drawn(DrivingStyle::kPatrol, near(kPatrolling, random), 0.0, 100, random));
    drives.push_back(drawn(DrivingStyle::kStroll, near(kStrolling, random), -1.5, 4000, random));
  }
  const BeliefModel model = fitBeliefModel(drives);
  const BeliefModel::Expert& stroll = model.expert(DrivingStyle::kStroll);
  EXPECT_NEAR(stroll.with_radio.intercept, 0.5, 0.06);
  EXPECT_NEAR(stroll.with_radio.features[1], -1.5, 0.06);
  EXPECT_NEAR(stroll.with_radio.features[13], -1.0, 0.06);
  EXPECT_NEAR(stroll.with_radio.features[5], 0.0, 0.06);
  EXPECT_EQ(stroll.without_radio.features[13], 0.0);  // of the radio
  EXPECT_NEAR(stroll.style_mean[0], 0.1, 0.1);
  EXPECT_NEAR(std::sqrt(stroll.style_covariance(0, 0)), 0.1, 0.05);
  EXPECT_GT(model.expert(DrivingStyle::kAlongWalls).with_radio.features[1], 1.3);
}

TEST(BeliefTraining, WeighsDrivesThatLookLikeAnotherStyle) {
  Random random(1, 1, 1);
  std::vector<TrainingCells> drives;
  for (int i = 0; i < 20; ++i) {
    // A third of the wall followers looks like patrols.
    const PathStyle& looks = i % 3 == 0 ? kPatrolling : kWallFollower;
    drives.push_back(drawn(DrivingStyle::kAlongWalls, near(looks, random), 1.5, 1000, random));
    drives.push_back(drawn(DrivingStyle::kPatrol, near(kPatrolling, random), 0.0, 1000, random));
    drives.push_back(drawn(DrivingStyle::kStroll, near(kStrolling, random), 0.0, 100, random));
  }
  const double patrol = fitBeliefModel(drives).expert(DrivingStyle::kPatrol).with_radio.features[1];
  EXPECT_GT(patrol, 0.15);
  EXPECT_LT(patrol, 1.0);
}

TEST(BeliefTraining, RefusesTooFewDrives) {
  EXPECT_THROW(fitBeliefModel({TrainingCells{}}), std::invalid_argument);
}

}  // namespace
}  // namespace sfw::test
