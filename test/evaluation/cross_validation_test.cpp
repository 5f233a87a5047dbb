#include "evaluation/cross_validation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "simulation/scenario.h"
#include "support/recorded_readings.h"

namespace sfw {
namespace {

const std::atomic<bool> kNeverStop{false};

/// A hall of 8 x 6 m driven in lanes 0.8 m apart; a wall at x = 4 of some loss, and access points
/// on both sides of it.
struct Hall {
  explicit Hall(double wall_db, double noise_db) {
    for (std::size_t i = 0; i < 2; ++i) {
      access_points.push_back({numberedBssid(i + 1),
                               "",
                               {1.0 + 6.0 * static_cast<double>(i), 3.1},
                               std::nullopt,
                               std::nullopt});
    }
    Random random(1, 2, 3);
    std::int64_t stamp = 0;
    for (int lane = 0; lane < 8; ++lane) {
      for (int step = 0; step < 80; ++step) {
        const int along = lane % 2 == 0 ? step : 79 - step;
        const Position place(0.05 + 0.1 * along, 0.2 + 0.8 * lane);
        for (const AccessPoint& access_point : access_points) {
          const bool behind = (place.x() < 4.0) != (access_point.position.x() < 4.0);
          const double distance = std::max(0.3, (place - access_point.position).norm());
          const double rssi = -40.0 - 20.0 * std::log10(distance) - (behind ? wall_db : 0.0);
          readings.push_back(
              {++stamp, place, access_point.bssid, rssi + noise_db * random.normal()});
        }
      }
    }
  }

  std::vector<Reading> readings;
  std::vector<AccessPoint> access_points;
};

PredictionMetrics metricsOf(const Hall& hall) {
  const auto metrics = predictHiddenStretches(hall.readings, hall.access_points, {}, kNeverStop);
  EXPECT_TRUE(metrics.has_value());
  return metrics.value_or(PredictionMetrics());
}

TEST(Prediction, IsExactWhereOnlyDistanceMatters) {
  const PredictionMetrics metrics = metricsOf(Hall(0.0, 0.0));
  EXPECT_GT(metrics.bins, 500u);
  EXPECT_LT(metrics.distance_db, 0.2);
  EXPECT_LT(metrics.walls_db, 0.3);
  EXPECT_LT(metrics.distance_shadowed_db, 1.0);  // its bins of half a metre blur the law
}

TEST(Prediction, BaselinesKnowNoDistance) {
  const PredictionMetrics metrics = metricsOf(Hall(0.0, 0.0));
  EXPECT_GT(metrics.kriging_db, 2.0 * metrics.distance_db);
  EXPECT_LT(metrics.kriging_db, 2.0);
  EXPECT_GT(metrics.mrpt_db, metrics.kriging_db);
  EXPECT_LT(metrics.mrpt_db, 4.0);
}

TEST(Prediction, LearnsOfAWallFromOtherStretches) {
  const PredictionMetrics metrics = metricsOf(Hall(9.0, 1.0));
  EXPECT_GT(metrics.distance_db, 2.0);
  EXPECT_LT(metrics.walls_db, 0.8 * metrics.distance_db);
  EXPECT_LT(metrics.walls_shadowed_db, metrics.distance_db);
}

TEST(Prediction, NoiseCannotBePredicted) {
  const PredictionMetrics metrics = metricsOf(Hall(0.0, 4.0));
  EXPECT_GT(metrics.distance_db, 2.0);  // two readings a bin
  EXPECT_GT(metrics.walls_db, metrics.distance_db - 0.1);
  EXPECT_LT(metrics.walls_db, metrics.distance_db + 0.4);
}

TEST(Prediction, DoesNotDependOnTheOrderOfReadings) {
  Hall hall(9.0, 1.0);
  const PredictionMetrics before = metricsOf(hall);
  std::reverse(hall.readings.begin(), hall.readings.end());
  EXPECT_EQ(metricsOf(hall).walls_db, before.walls_db);
}

TEST(Prediction, HasNoResultWithoutReadingsOfAnAccessPoint) {
  const Hall hall(9.0, 1.0);
  EXPECT_FALSE(predictHiddenStretches({}, hall.access_points, {}, kNeverStop));
  EXPECT_FALSE(predictHiddenStretches(hall.readings, {}, {}, kNeverStop));
  AccessPoint unheard = hall.access_points.front();
  unheard.bssid = numberedBssid(9);
  EXPECT_FALSE(predictHiddenStretches(hall.readings, {unheard}, {}, kNeverStop));
}

TEST(Prediction, HasNoResultOfAShortDrive) {
  Hall hall(9.0, 1.0);
  hall.readings.resize(40);  // 2 m: one stretch, nothing to predict it from
  EXPECT_FALSE(predictHiddenStretches(hall.readings, hall.access_points, {}, kNeverStop));
}

TEST(Prediction, RefusesWhatIsFartherThanABuilding) {
  Hall hall(9.0, 1.0);
  hall.access_points.front().position = {1e6, 1e6};
  EXPECT_FALSE(predictHiddenStretches(hall.readings, hall.access_points, {}, kNeverStop));
}

TEST(Prediction, Stops) {
  const Hall hall(9.0, 1.0);
  const std::atomic<bool> stop{true};
  EXPECT_FALSE(predictHiddenStretches(hall.readings, hall.access_points, {}, stop));
}

constexpr double kLeastGain = 0.3;  // [dB] that walls must explain to be worth mapping

TEST(Prediction, WallsHelpOnRealRecordings) {
  const std::vector<test::RealRecording> recordings = test::realRecordings();
  if (recordings.empty()) {
    GTEST_SKIP() << test::kNoRecordings;
  }
  for (const test::RealRecording& recording : recordings) {
    const auto metrics =
        predictHiddenStretches(recording.readings, recording.access_points, {}, kNeverStop);
    ASSERT_TRUE(metrics) << recording.name;
    EXPECT_GT(metrics->distance_db - metrics->walls_db, kLeastGain) << recording.name;
    for (const double other_db : {metrics->distance_db, metrics->kriging_db, metrics->mrpt_db}) {
      EXPECT_LT(metrics->walls_shadowed_db, other_db) << recording.name;
    }
    RecordProperty(recording.name, std::to_string(metrics->distance_db - metrics->walls_db));
  }
}

}  // namespace
}  // namespace sfw
