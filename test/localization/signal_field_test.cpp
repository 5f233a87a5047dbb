#include "localization/signal_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "localization/heard_hall.h"

namespace sfw {
namespace {

constexpr double kNoiseDb = 2.0;

std::vector<Sample> samples(double lane_step_m = 1.0) {
  Random random(3, 1, 4);
  std::vector<Sample> result;
  for (double y = 0.0; y <= 12.0; y += lane_step_m) {
    for (double x = 0.0; x <= 20.0; x += 0.5) {
      const Position at(x, y);
      result.push_back({at, HeardHall::meanDbm(2, at) + kNoiseDb * random.normal()});
    }
  }
  return result;
}

double rmsError(const SignalField& field) {
  std::vector<Position> between;
  for (double y = 0.5; y < 12.0; y += 1.0) {
    for (double x = 0.7; x < 20.0; x += 1.0) {
      between.emplace_back(x, y);
    }
  }
  const SignalPrediction predicted = field.predict(between);
  double squares = 0.0;
  for (std::size_t i = 0; i < between.size(); ++i) {
    const double error = predicted.mean_dbm[i] - HeardHall::meanDbm(2, between[i]);
    squares += error * error;
  }
  return std::sqrt(squares / static_cast<double>(between.size()));
}

TEST(SignalField, PredictsBetweenLanesBetterThanASingleReading) {
  const SignalLaw law = learnSignalLaw(samples(), std::nullopt);
  EXPECT_LT(rmsError(SignalField(samples(), law)), 0.6 * kNoiseDb);
}

TEST(SignalField, FindsTheSource) {
  const SignalLaw law = learnSignalLaw(samples(), std::nullopt);
  ASSERT_TRUE(law.source);
  EXPECT_LT((*law.source - HeardHall::placeOf(2)).norm(), 3.0);
}

TEST(SignalField, KnowsHowSureItIs) {
  const std::vector<Sample> heard = samples();
  const SignalField field(heard, learnSignalLaw(heard, std::nullopt));
  Random random(5, 1, 4);
  double squares = 0.0;
  int count = 0;
  for (double y = 0.5; y < 12.0; y += 1.0) {
    for (double x = 0.7; x < 20.0; x += 1.0, ++count) {
      const Position at(x, y);
      const SignalPrediction predicted = field.predict({at});
      const double reading = HeardHall::meanDbm(2, at) + kNoiseDb * random.normal();
      squares += std::pow((reading - predicted.mean_dbm[0]) / predicted.deviation_db[0], 2);
    }
  }
  EXPECT_NEAR(std::sqrt(squares / count), 1.0, 0.25);
}

TEST(SignalField, IsUnsureFarFromReadings) {
  const std::vector<Sample> heard = samples();
  const SignalPrediction predicted =
      SignalField(heard, learnSignalLaw(heard, std::nullopt)).predict({{10.0, 6.0}, {60.0, 60.0}});
  EXPECT_GT(predicted.deviation_db[1], predicted.deviation_db[0] + 0.5);
}

TEST(SignalField, AFewWildReadingsDoLittleHarm) {
  std::vector<Sample> heard = samples();
  for (std::size_t i = 7; i < heard.size(); i += 40) {
    heard[i].rssi_dbm = -20.0;
  }
  EXPECT_LT(rmsError(SignalField(heard, learnSignalLaw(heard, std::nullopt))), 2.0 * kNoiseDb);
}

TEST(SignalField, OneReadingIsEnough) {
  const std::vector<Sample> one = {{{3.0, 4.0}, -60.0}};
  const SignalPrediction predicted =
      SignalField(one, learnSignalLaw(one, std::nullopt)).predict({{3.0, 4.0}, {300.0, 4.0}});
  EXPECT_NEAR(predicted.mean_dbm[0], -60.0, 3.0);
  EXPECT_TRUE(std::isfinite(predicted.mean_dbm[1]));
}

}  // namespace
}  // namespace sfw
