#include "access_points/access_point_estimation.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "simulation/building/floor_plan_io.h"
#include "simulation/radio/random_field.h"
#include "simulation/scenario.h"
#include "support/floor_plans.h"
#include "support/recorded_readings.h"

namespace sfw {
namespace {

constexpr double kNoise = 2.0;  // [dB]

Sample sampleAt(const Position& place, const Position& access_point, double height,
                Random& random) {
  const double distance = std::max(0.3, std::hypot((place - access_point).norm(), height));
  return {place, -40.0 - 20.0 * std::log10(distance) + kNoise * random.normal()};
}

/// Through a hall of 8 x 6 m, in lanes 1 m apart.
std::vector<Sample> hallDrive(const Position& access_point, double height = 0.0) {
  Random random(4, 5, 6);
  std::vector<Sample> samples;
  for (int lane = 0; lane <= 6; ++lane) {
    for (int step = 0; step <= 80; ++step) {
      const Position place(0.1 * (lane % 2 == 0 ? step : 80 - step), lane);
      samples.push_back(sampleAt(place, access_point, height, random));
    }
  }
  return samples;
}

std::vector<Sample> straightDrive(const Position& access_point) {
  Random random(4, 5, 6);
  std::vector<Sample> samples;
  for (int i = 0; i < 100; ++i) {
    samples.push_back(sampleAt({0.1 * i, 0.0}, access_point, 0.0, random));
  }
  return samples;
}

TEST(AccessPointEstimation, FindsAnAccessPointInsideThePath) {
  const Position truth(5.0, 2.2);
  const auto estimate = estimateAccessPoint(hallDrive(truth));
  ASSERT_TRUE(estimate);
  const Position error = estimate->position - truth;
  EXPECT_LT(error.norm(), 0.4);
  EXPECT_LT(error.dot(estimate->covariance.inverse() * error), 9.0);
  EXPECT_FALSE(estimate->ambiguous);
  EXPECT_EQ(estimate->readings, 567u);
  EXPECT_GT(estimate->bins, 100u);
}

TEST(AccessPointEstimation, KnowsLessOfOneOutsideThePath) {
  const auto inside = estimateAccessPoint(hallDrive({5.0, 2.2}));
  const auto outside = estimateAccessPoint(hallDrive({5.0, 9.0}));
  ASSERT_TRUE(inside);
  ASSERT_TRUE(outside);
  EXPECT_GT(outside->covariance.trace(), 2.0 * inside->covariance.trace());
  const Position error = outside->position - Position(5.0, 9.0);
  EXPECT_LT(error.dot(outside->covariance.inverse() * error), 9.0);
}

TEST(AccessPointEstimation, DoesNotDependOnTheOrderOfSamples) {
  std::vector<Sample> samples = hallDrive({5.0, 2.2});
  const auto before = estimateAccessPoint(samples);
  std::reverse(samples.begin(), samples.end());
  std::rotate(samples.begin(), samples.begin() + 77, samples.end());
  const auto after = estimateAccessPoint(samples);
  ASSERT_TRUE(before);
  ASSERT_TRUE(after);
  EXPECT_EQ(before->position, after->position);
  EXPECT_EQ(before->covariance, after->covariance);
}

TEST(AccessPointEstimation, DoesNotAverageTheTwoSidesOfAStraightPath) {
  for (const double side : {-3.0, 3.0}) {
    const auto estimate = estimateAccessPoint(straightDrive({4.0, side}));
    ASSERT_TRUE(estimate);
    EXPECT_TRUE(estimate->ambiguous);
    EXPECT_NEAR(estimate->position.x(), 4.0, 0.7);
    EXPECT_NEAR(std::abs(estimate->position.y()), 3.0, 1.5);
    EXPECT_GT(std::sqrt(estimate->covariance(1, 1)), 3.0) << "must reach the other side";
  }
}

TEST(AccessPointEstimation, RefusesTooLittle) {
  std::vector<Sample> samples = hallDrive({5.0, 2.2});
  EXPECT_FALSE(estimateAccessPoint({}));
  samples.resize(30);  // 3 m, 8 bins
  EXPECT_FALSE(estimateAccessPoint(samples));
}

TEST(AccessPointEstimation, RefusesSignalsThatAreAllAlike) {
  std::vector<Sample> samples = hallDrive({5.0, 2.2});
  for (Sample& sample : samples) {
    sample.rssi_dbm = -60.0;
  }
  EXPECT_FALSE(estimateAccessPoint(samples));
}

TEST(AccessPointEstimation, UsesAKnownHeight) {
  const Position truth(5.0, 2.2);
  const std::vector<Sample> samples = hallDrive(truth, 2.0);  // antenna at .6, access point at 2.6
  const auto known = estimateAccessPoint(samples, 2.6);
  const auto unknown = estimateAccessPoint(samples);
  ASSERT_TRUE(known);
  ASSERT_TRUE(unknown);
  EXPECT_LT((known->position - truth).norm(), 1.5);
  EXPECT_LT((known->position - truth).norm(), (unknown->position - truth).norm());
}

/// Signals of a hall with shadows: a random field that many neighbouring readings share.
std::vector<Sample> shadowed(std::vector<Sample> samples, double shadowing_db, double distance_m) {
  const RandomField field(RandomField::Kind::kRough, distance_m, 11, 12);
  for (Sample& sample : samples) {
    sample.rssi_dbm += shadowing_db * field.at(sample.antenna_in_map);
  }
  return samples;
}

TEST(AccessPointEstimation, KnowsLessWhereShadowsAreStrong) {
  const Position truth(5.0, 2.2);
  double last = 0.0;
  for (const double shadowing_db : {0.0, 2.0, 6.0}) {
    const auto estimate = estimateAccessPoint(shadowed(hallDrive(truth), shadowing_db, 1.5));
    ASSERT_TRUE(estimate);
    const Position error = estimate->position - truth;
    EXPECT_LT(error.dot(estimate->covariance.inverse() * error), 9.0) << shadowing_db;
    EXPECT_GT(estimate->covariance.trace(), 1.2 * last) << shadowing_db;
    last = estimate->covariance.trace();
  }
}

TEST(AccessPointPrior, StaysAsItIsWithoutReadings) {
  const AccessPointEstimate estimate = estimateAccessPoint({}, PositionPrior{{3.0, 4.0}, 1.5});
  EXPECT_EQ(estimate.position, Position(3.0, 4.0));
  EXPECT_EQ(estimate.covariance, Eigen::Matrix2d(2.25 * Eigen::Matrix2d::Identity()));
  EXPECT_EQ(estimate.readings, 0u);
  EXPECT_FALSE(estimate.ambiguous);
}

TEST(AccessPointPrior, MovesTowardsTheReadingsTheMoreTheWiderItIs) {
  const Position truth(5.0, 2.2);
  const std::vector<Sample> samples = hallDrive(truth);
  const Position given = truth + Position(0.0, 2.0);
  double last = 2.0;
  for (const double deviation_m : {0.05, 0.3, 3.0}) {
    const auto estimate = estimateAccessPoint(samples, PositionPrior{given, deviation_m});
    const double error = (estimate.position - truth).norm();
    EXPECT_LT(error, last) << deviation_m;
    EXPECT_LT(std::sqrt(estimate.covariance.trace()), 1.5 * deviation_m) << deviation_m;
    last = error;
  }
  EXPECT_LT(last, 0.4);
}

TEST(AccessPointPrior, IsTheEstimateFromReadingsAloneIfItIsVeryWide) {
  const std::vector<Sample> samples = hallDrive({5.0, 2.2});
  const auto alone = estimateAccessPoint(samples);
  ASSERT_TRUE(alone);
  const auto wide = estimateAccessPoint(samples, PositionPrior{{4.0, 3.0}, 1000.0});
  EXPECT_LT((wide.position - alone->position).norm(), 0.05);
  EXPECT_LT((wide.covariance - alone->covariance).norm(), 0.1 * alone->covariance.norm());
}

TEST(AccessPointPrior, TellsTheSidesOfAStraightPathApart) {
  const auto samples = straightDrive({4.0, 3.0});
  const auto estimate = estimateAccessPoint(samples, PositionPrior{{4.5, 4.0}, 1.5});
  EXPECT_FALSE(estimate.ambiguous);
  EXPECT_NEAR(estimate.position.y(), 3.0, 1.5);
  EXPECT_LT(estimate.covariance(1, 1), 1.5 * 1.5);
}

TEST(AccessPointPrior, HoldsOutsideTheSearchOfReadingsAlone) {
  const Position given(5.0, 40.0);  // 34 m from the hall
  const auto estimate = estimateAccessPoint(hallDrive({5.0, 2.2}), PositionPrior{given, 0.5});
  EXPECT_LT((estimate.position - given).norm(), 2.0);
  EXPECT_TRUE(estimate.covariance.allFinite());
}

TEST(AccessPointFit, SuspectsAGivenPositionByItsDeviation) {
  const Position truth(5.0, 2.2);
  const std::vector<Sample> samples = hallDrive(truth);
  const Position given = truth + Position(-3.0, 0.0);
  const auto exact = accessPointFit(samples, given);
  ASSERT_TRUE(exact);
  EXPECT_TRUE(exact->suspect);
  double last = exact->log_ratio;
  for (const double deviation_m : {0.1, 0.5, 3.0}) {
    const auto fit = accessPointFit(samples, given, std::nullopt, deviation_m);
    ASSERT_TRUE(fit);
    EXPECT_LT(fit->log_ratio, last) << deviation_m;
    EXPECT_EQ(fit->estimate.position, exact->estimate.position);
    last = fit->log_ratio;
  }
  EXPECT_TRUE(accessPointFit(samples, given, std::nullopt, 0.1)->suspect);
  EXPECT_FALSE(accessPointFit(samples, given, std::nullopt, 3.0)->suspect);
}

TEST(AccessPointFit, NeedsReadings) {
  EXPECT_FALSE(accessPointFit({}, Position::Zero()));
  EXPECT_FALSE(accessPointFit({{Position(1.0, 2.0), -50.0}}, Position::Zero()));
  EXPECT_FALSE(accessPointFit(std::vector<Sample>(1000, {Position(1.0, 2.0), -50.0}),
                              Position::Zero(), 2.0));
}

TEST(AccessPointFit, TrustsTheRightPlaceAndSuspectsOthers) {
  const Position truth(5.0, 2.2);
  const std::vector<Sample> samples = hallDrive(truth);
  const auto right = accessPointFit(samples, truth);
  ASSERT_TRUE(right);
  EXPECT_FALSE(right->suspect);
  EXPECT_LT(right->residual_db, kNoise);
  for (const Position& move : {Position(3, 0), Position(-3, 0), Position(0, 3), Position(0, -3)}) {
    const auto wrong = accessPointFit(samples, truth + move);
    ASSERT_TRUE(wrong);
    EXPECT_TRUE(wrong->suspect) << move.transpose();
    EXPECT_NEAR(wrong->distance_m, 3.0, 0.5);
    EXPECT_GT(wrong->residual_db, right->residual_db);
  }
}

TEST(AccessPointEstimation, IsGoodInSimulatedHomes) {
  constexpr std::size_t kFits = 24;
  constexpr double kLost = 10.0;  // [m]
  std::vector<double> errors;
  int suspects = 0;
  for (const std::string& file : test::floorPlans()) {
    if (file.find("houseexpo") == std::string::npos || errors.size() >= kFits) {
      continue;
    }
    ScenarioConfig config;
    config.access_points = 2;
    config.seed = static_cast<std::int64_t>(errors.size());
    const Scenario scenario = makeScenario(readFloorPlan(file), {}, config);
    auto samples = test::samplesByRadio(simulate(scenario).readings);
    for (const AccessPoint& access_point : scenario.access_points) {
      const auto fit = accessPointFit(samples[access_point.bssid], access_point.position);
      errors.push_back(fit ? fit->distance_m : kLost);
      suspects += fit && fit->suspect ? 1 : 0;
    }
  }
  if (errors.empty()) {
    GTEST_SKIP() << test::kNoFloorPlans;
  }
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[errors.size() / 2], 0.6);
  EXPECT_LT(errors[errors.size() * 3 / 4], 1.5);
  EXPECT_LE(suspects, 1);
}

TEST(AccessPointEstimation, IsGoodAtARealHome) {
  const std::vector<test::RealRecording> recordings = test::realRecordings();
  if (recordings.empty()) {
    GTEST_SKIP() << test::kNoRecordings;
  }
  for (const test::RealRecording& recording : recordings) {
    if (recording.name.find("home") == std::string::npos) {
      continue;
    }
    auto samples = test::samplesByRadio(recording.readings);
    for (const AccessPoint& access_point : recording.access_points) {
      if (samples.count(access_point.bssid) != 0) {
        const auto fit = accessPointFit(samples[access_point.bssid], access_point.position);
        ASSERT_TRUE(fit);
        EXPECT_LT(fit->distance_m, 1.4) << recording.name << ' ' << access_point.name;
        EXPECT_FALSE(fit->suspect) << recording.name << ' ' << access_point.name;
      }
    }
  }
}

TEST(AccessPointFit, CovariancesHoldOnRealRecordings) {
  const std::vector<test::RealRecording> recordings = test::realRecordings();
  if (recordings.empty()) {
    GTEST_SKIP() << test::kNoRecordings;
  }
  double sum = 0.0;
  int count = 0;
  for (const test::RealRecording& recording : recordings) {
    auto samples = test::samplesByRadio(recording.readings);
    for (const AccessPoint& access_point : recording.access_points) {
      if (samples.count(access_point.bssid) != 0) {
        const auto fit = accessPointFit(samples[access_point.bssid], access_point.position,
                                        access_point.height_m);
        ASSERT_TRUE(fit);
        EXPECT_FALSE(fit->suspect) << recording.name << ' ' << access_point.name;
        const Position error = fit->estimate.position - access_point.position;
        sum += error.dot(fit->estimate.covariance.inverse() * error);
        ++count;
      }
    }
  }
  EXPECT_LT(sum / count, 5.0) << "2 if covariances were exact";
}

}  // namespace
}  // namespace sfw
