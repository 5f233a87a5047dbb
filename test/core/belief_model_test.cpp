#include "structure_from_wifi/belief_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

#include "structure_from_wifi/belief_training.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/random.h"

namespace sfw::test {
namespace {

BeliefModel::Expert expertAround(double rim_share, double winding) {
  BeliefModel::Expert expert;
  expert.style_mean = BeliefModel::styleVector({rim_share, 0.5, winding});
  expert.style_covariance = 0.01 * Eigen::Matrix3d::Identity();
  return expert;
}

std::array<float, kCellFeatures> cellWith(std::size_t feature, float value) {
  std::array<float, kCellFeatures> cell{};
  cell[feature] = value;
  return cell;
}

TEST(BeliefModel, IsLogisticInItsFeatures) {
  BeliefModel::Expert expert = expertAround(0.5, 0.05);
  expert.with_radio.intercept = 1.0;
  expert.with_radio.features[3] = -2.0;
  expert.without_radio.intercept = -1.0;
  const BeliefModel model(expert, expertAround(0.1, 0.3));
  EXPECT_NEAR(model.free(cellWith(3, 0.5F), 1.0, true), 0.5, 1e-9);
  EXPECT_NEAR(model.free(cellWith(3, 0.0F), 1.0, true), 1.0 / (1.0 + std::exp(-1.0)), 1e-9);
  EXPECT_NEAR(model.free(cellWith(3, 0.5F), 1.0, false), 1.0 / (1.0 + std::exp(1.0)), 1e-9);
}

TEST(BeliefModel, ChoosesTheExpertByThePathsStyle) {
  const BeliefModel model(expertAround(0.5, 0.05), expertAround(0.1, 0.3));
  EXPECT_EQ(model.followsWalls({0.5, 0.5, 0.05}), 1.0);
  EXPECT_EQ(model.followsWalls({0.1, 0.5, 0.3}), 0.0);
}

TEST(BeliefModel, RefusesNumbersThatAreNone) {
  BeliefModel::Expert broken = expertAround(0.5, 0.05);
  broken.with_radio.features[0] = std::nan("");
  EXPECT_THROW(BeliefModel(broken, expertAround(0.1, 0.3)), std::invalid_argument);
  broken = expertAround(0.5, 0.05);
  broken.style_covariance(0, 0) = -1.0;
  EXPECT_THROW(BeliefModel(expertAround(0.1, 0.3), broken), std::invalid_argument);
}

TEST(BeliefModel, ComesBackFromItsFile) {
  BeliefModel::Expert expert = expertAround(0.4, 0.06);
  for (std::size_t i = 0; i < kCellFeatures; ++i) {
    expert.with_radio.features[i] = 0.25 * static_cast<double>(i) - 3.0;
  }
  const BeliefModel model(expert, expertAround(0.1, 0.3));
  const BeliefModel back = parseBeliefModel(toYaml(model), "model.yaml");
  EXPECT_EQ(toYaml(back), toYaml(model));
  EXPECT_EQ(back.followsWalls().with_radio.features, expert.with_radio.features);
}

TEST(BeliefModel, NamesTheFileAndWhatItLacks) {
  std::string text = toYaml(BeliefModel(expertAround(0.4, 0.06), expertAround(0.1, 0.3)));
  const std::string lacking = text.replace(text.find("    rays: "), 5, "    rain:");
  for (const std::string& malformed : {lacking, std::string("nonsense"), std::string()}) {
    try {
      parseBeliefModel(malformed, "bad.yaml");
      FAIL() << malformed;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find("bad.yaml"), 0U) << error.what();
    }
  }
}

/// Where walls take `wall` of what signals can lose, and `sight` of them is left.
std::array<float, kCellFeatures> cellHeard(float wall, float sight) {
  constexpr float kExplained = 0.6F;
  std::map<std::string, float> values{{"line_of_sight", sight},
                                      {"wall_strength", wall},
                                      {"wall_beside", wall},
                                      {"explained", kExplained},
                                      {"explained_line_of_sight", kExplained * sight},
                                      {"explained_wall_strength", kExplained * wall},
                                      {"explained_wall_beside", kExplained * wall}};
  const auto bend = [&](const char* name, float value, float limit) {
    values[name] = std::max(0.0F, value - limit);
  };
  bend("line_of_sight_over_0.1", sight, 0.1F);
  bend("line_of_sight_over_0.4", sight, 0.4F);
  bend("wall_strength_over_0.1", wall, 0.1F);
  bend("wall_beside_over_0.02", wall, 0.02F);
  bend("wall_beside_over_0.1", wall, 0.1F);
  std::array<float, kCellFeatures> cell{};
  for (std::size_t i = 0; i < kCellFeatures; ++i) {
    const auto found = values.find(cellFeatureNames()[i]);
    cell[i] = found != values.end() ? found->second : 0.0F;
  }
  return cell;
}

TEST(BeliefModel, IsShippedAndTakesWallsForWalls) {
  const BeliefModel model = shippedBeliefModel();
  for (const double follows_walls : {0.0, 1.0}) {
    const auto free = [&](float wall, float sight) {
      return model.free(cellHeard(wall, sight), follows_walls, true);
    };
    // More wall on the radio's part makes no cell freer, where there are rays at all: below 0.02
    // the features tell cells that no ray passes near.
    EXPECT_GT(free(0.02F, 0.5F), free(0.1F, 0.5F));
    EXPECT_GT(free(0.1F, 0.5F), free(0.3F, 0.5F));
    EXPECT_GT(free(0.3F, 0.5F), free(0.6F, 0.5F));
    EXPECT_LT(free(0.05F, 0.1F), free(0.05F, 0.4F));
    EXPECT_LT(free(0.05F, 0.4F), free(0.05F, 0.9F));
  }
  for (std::size_t i = 0; i < kCellFeatures; ++i) {
    if (usesRadio(i)) {
      EXPECT_EQ(model.followsWalls().without_radio.features[i], 0.0) << cellFeatureNames()[i];
      EXPECT_EQ(model.anyPath().without_radio.features[i], 0.0) << cellFeatureNames()[i];
    }
  }
}

TEST(BeliefTraining, FindsTheWeightsThatMadeTheCells) {
  Random random(1, 1, 1);
  TrainingCells training;
  for (int drive = 0; drive < 20; ++drive) {
    training.styles.push_back(BeliefModel::styleVector(
        {0.4 + 0.1 * random.normal(), 0.5 + 0.1 * random.normal(), 0.05 + 0.01 * random.normal()}));
  }
  for (int i = 0; i < 40000; ++i) {
    std::array<float, kCellFeatures> cell{};
    for (float& value : cell) {
      value = static_cast<float>(random.normal());
    }
    const double score = 0.5 + 1.5 * static_cast<double>(cell[1]) - static_cast<double>(cell[12]);
    training.cells.push_back(cell);
    training.free.push_back(random.uniform() < 1.0 / (1.0 + std::exp(-score)) ? 1 : 0);
  }
  const BeliefModel::Expert expert = fitExpert(training);
  EXPECT_NEAR(expert.with_radio.intercept, 0.5, 0.06);
  EXPECT_NEAR(expert.with_radio.features[1], 1.5, 0.06);
  EXPECT_NEAR(expert.with_radio.features[12], -1.0, 0.06);
  EXPECT_NEAR(expert.with_radio.features[5], 0.0, 0.06);
  EXPECT_EQ(expert.without_radio.features[12], 0.0);  // of the radio
  EXPECT_NEAR(expert.style_mean[0], 0.4, 0.1);
  EXPECT_NEAR(std::sqrt(expert.style_covariance(0, 0)), 0.1, 0.05);
}

TEST(BeliefTraining, RefusesTooFewDrives) {
  TrainingCells training;
  training.cells.emplace_back();
  training.free.push_back(1);
  EXPECT_THROW(fitExpert(training), std::invalid_argument);
}

}  // namespace
}  // namespace sfw::test
