#include "belief/belief_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

#include "structure_from_wifi/input_error.h"

namespace sfw::test {
namespace {

const PathStyle kWallFollower{0.5, 0.5, 0.05};
const PathStyle kPatrolling{0.9, 0.5, 0.05};
const PathStyle kStrolling{0.1, 0.5, 0.3};

constexpr StyleShares kOnlyAlongWalls{1.0, 0.0, 0.0};

BeliefModel::Expert expertFor(const PathStyle& style) {
  BeliefModel::Expert expert;
  expert.style_mean = BeliefModel::styleVector(style);
  expert.style_covariance = 0.01 * Eigen::Matrix3d::Identity();
  return expert;
}

BeliefModel modelWith(const BeliefModel::Expert& along_walls) {
  return BeliefModel({along_walls, expertFor(kPatrolling), expertFor(kStrolling)});
}

FeatureVector cellWith(std::size_t feature, float value) {
  FeatureVector cell{};
  cell[feature] = value;
  return cell;
}

TEST(BeliefModel, IsLogisticInItsFeatures) {
  BeliefModel::Expert expert = expertFor(kWallFollower);
  expert.with_radio.intercept = 1.0;
  expert.with_radio.features[3] = -2.0;
  expert.without_radio.intercept = -1.0;
  const BeliefModel model = modelWith(expert);
  EXPECT_NEAR(model.free(cellWith(3, 0.5F), kOnlyAlongWalls, UseRadio::kYes), 0.5, 1e-9);
  EXPECT_NEAR(model.free(cellWith(3, 0.0F), kOnlyAlongWalls, UseRadio::kYes),
              1.0 / (1.0 + std::exp(-1.0)), 1e-9);
  EXPECT_NEAR(model.free(cellWith(3, 0.5F), kOnlyAlongWalls, UseRadio::kNo),
              1.0 / (1.0 + std::exp(1.0)), 1e-9);
}

TEST(BeliefModel, ChoosesTheExpertByThePathsStyle) {
  const BeliefModel model = modelWith(expertFor(kWallFollower));
  EXPECT_EQ(model.shares(kWallFollower), (StyleShares{1.0, 0.0, 0.0}));
  EXPECT_EQ(model.shares(kPatrolling), (StyleShares{0.0, 1.0, 0.0}));
  EXPECT_EQ(model.shares(kStrolling), (StyleShares{0.0, 0.0, 1.0}));
}

TEST(BeliefModel, MixesExpertsWhereAStyleFitsTwo) {
  BeliefModel::Expert sure = expertFor(kWallFollower);
  sure.with_radio.intercept = 2.0;
  const BeliefModel model = modelWith(sure);
  const StyleShares shares = model.shares({0.7, 0.5, 0.05});  // midway to patrols
  EXPECT_NEAR(shares[0], 0.5, 1e-6);
  EXPECT_NEAR(shares[1], 0.5, 1e-6);
  EXPECT_NEAR(model.free({}, shares, UseRadio::kYes), 0.5 / (1.0 + std::exp(-2.0)) + 0.5 * 0.5,
              1e-6);
}

TEST(BeliefModel, RefusesNumbersThatAreNone) {
  BeliefModel::Expert broken = expertFor(kWallFollower);
  broken.with_radio.features[0] = std::nan("");
  EXPECT_THROW(modelWith(broken), std::invalid_argument);
  broken = expertFor(kWallFollower);
  broken.style_covariance(0, 0) = -1.0;
  EXPECT_THROW(modelWith(broken), std::invalid_argument);
}

TEST(BeliefModel, ComesBackFromItsFile) {
  BeliefModel::Expert expert = expertFor(kWallFollower);
  for (std::size_t i = 0; i < kCellFeatures; ++i) {
    expert.with_radio.features[i] = 0.25 * static_cast<double>(i) - 3.0;
  }
  const BeliefModel model = modelWith(expert);
  const BeliefModel back = parseBeliefModel(toYaml(model), "model.yaml");
  EXPECT_EQ(toYaml(back), toYaml(model));
  EXPECT_EQ(back.expert(DrivingStyle::kAlongWalls).with_radio.features, expert.with_radio.features);
}

TEST(BeliefModel, NamesTheFileOfAMalformedModel) {
  std::string lacking = toYaml(modelWith(expertFor(kWallFollower)));
  lacking.replace(lacking.find("    rays: "), 9, "    rain:");
  std::string without_style = toYaml(modelWith(expertFor(kWallFollower)));
  without_style.replace(without_style.find("patrol:"), 7, "errand:");
  for (const std::string& malformed :
       {lacking, without_style, std::string("nonsense"), std::string()}) {
    try {
      parseBeliefModel(malformed, "bad.yaml");
      FAIL() << malformed;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find("bad.yaml"), 0U) << error.what();
    }
  }
}

std::string errorOf(const std::string& yaml) {
  try {
    parseBeliefModel(yaml, "bad.yaml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(BeliefModel, RefusesAnotherFormatAndNamesARemedy) {
  const std::string good = toYaml(modelWith(expertFor(kWallFollower)));
  ASSERT_EQ(good.find("format: 1\n"), 0U);
  EXPECT_EQ(errorOf(good), "");
  const std::string other = "format: 2" + good.substr(good.find('\n'));
  const std::string none = good.substr(good.find('\n') + 1);
  for (const std::string& error : {errorOf(other), errorOf(none)}) {
    EXPECT_NE(error.find("this version reads format 1"), std::string::npos) << error;
    EXPECT_NE(error.find("sfw fit"), std::string::npos) << error;
  }
  EXPECT_NE(errorOf(other).find("has format 2"), std::string::npos) << errorOf(other);
  EXPECT_NE(errorOf(none).find("has no key format"), std::string::npos) << errorOf(none);
  EXPECT_NE(errorOf("format: new" + good.substr(good.find('\n'))), "");
}

TEST(BeliefModel, RefusesAFeatureThatItDoesNotKnow) {
  std::string more = toYaml(modelWith(expertFor(kWallFollower)));
  more.insert(more.find("    rays: "), "    rain: 1\n");
  EXPECT_NE(errorOf(more).find("nothing else"), std::string::npos) << errorOf(more);
}

/// Where walls take `wall` of what signals can lose, and `sight` of them is left.
FeatureVector cellWithWalls(float wall, float sight) {
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
  FeatureVector cell{};
  for (std::size_t i = 0; i < kCellFeatures; ++i) {
    const auto found = values.find(kCellFeatureTable[i].name);
    cell[i] = found != values.end() ? found->second : 0.0F;
  }
  return cell;
}

TEST(BeliefModel, IsShippedAndTakesWallsForWalls) {
  const BeliefModel model = shippedBeliefModel();
  for (std::size_t style = 0; style < kDrivingStyles; ++style) {
    SCOPED_TRACE(kDrivingStyleNames[style]);
    StyleShares shares{};
    shares[style] = 1.0;
    const auto free = [&](float wall, float sight) {
      return model.free(cellWithWalls(wall, sight), shares, UseRadio::kYes);
    };
    // More wall on the radio's part makes no cell freer. Below 0.1 the errors of signals and of
    // access points make as much, and below 0.02 no ray passes near.
    EXPECT_GT(free(0.1F, 0.5F), free(0.3F, 0.5F));
    EXPECT_GT(free(0.3F, 0.5F), free(0.6F, 0.5F));
    EXPECT_LT(free(0.05F, 0.1F), free(0.05F, 0.9F));
    EXPECT_LT(free(0.05F, 0.4F), free(0.05F, 0.9F));
    const BeliefModel::Expert& expert = model.expert(static_cast<DrivingStyle>(style));
    for (std::size_t i = 0; i < kCellFeatures; ++i) {
      if (kCellFeatureTable[i].uses_radio) {
        EXPECT_EQ(expert.without_radio.features[i], 0.0) << kCellFeatureTable[i].name;
      }
    }
  }
}

}  // namespace
}  // namespace sfw::test
