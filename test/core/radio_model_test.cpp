#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/simulation.h"

namespace sfw {
namespace {

/// A hall of 0.1 m cells with a wall a metre thick from x = 50 to 51.
Grid<CellState> hall() {
  Grid<CellState> plan(GridGeometry(0.1, Position::Zero(), 1000, 400), CellState::kFree);
  Cell c;
  for (c.y = 0; c.y < plan.geometry.height(); ++c.y) {
    for (c.x = 500; c.x < 510; ++c.x) {
      plan[c] = CellState::kOccupied;
    }
  }
  return plan;
}

AccessPoint accessPointAt(const Position& position, const char* bssid = "02:00:00:00:00:01") {
  AccessPoint access_point;
  access_point.bssid = *Bssid::parse(bssid);
  access_point.position = position;
  return access_point;
}

RadioModel::Config quietRadio() {
  RadioModel::Config config;
  config.shadowing = 0.0;
  config.sample_noise = 0.0;
  return config;
}

struct Moments {
  double mean = 0.0;
  double deviation = 0.0;
};

Moments momentsOf(const std::vector<double>& values) {
  double sum = 0.0, squares = 0.0;
  for (const double value : values) {
    sum += value;
    squares += value * value;
  }
  const auto count = static_cast<double>(values.size());
  return {sum / count, std::sqrt(squares / count - sum * sum / (count * count))};
}

std::string messageOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no error";
}

TEST(RadioModel, LosesByDistanceAndWalls) {
  RadioModel::Config config = quietRadio();
  config.rssi_at_1m = -30.0;
  config.exponent = 2.0;
  config.wall_loss = 6.0;
  const RadioModel radio(hall(), {accessPointAt({45.0, 20.0})}, config);
  EXPECT_NEAR(radio.meanRssi(0, {44.0, 20.0}), -30.0, 1e-9);
  EXPECT_NEAR(radio.meanRssi(0, {35.0, 20.0}), -50.0, 1e-9);
  EXPECT_NEAR(radio.meanRssi(0, {55.0, 20.0}), -56.0, 1e-9);
  EXPECT_EQ(radio.rssi(0, {35.0, 20.0}, 0), -50.0);
  EXPECT_LE(*radio.rssi(0, {45.0, 20.0}, 0), 0.0);  // on the access point itself
}

TEST(RadioModel, AnAccessPointOnTheCeilingIsNeverNear) {
  RadioModel::Config config = quietRadio();
  config.rssi_at_1m = -30.0;
  config.exponent = 2.0;
  config.antenna_height = 0.5;
  AccessPoint access_point = accessPointAt({10.0, 10.0});
  access_point.height_m = 3.5;
  const RadioModel radio(hall(), {access_point}, config);
  EXPECT_NEAR(radio.meanRssi(0, {10.0, 10.0}), -30.0 - 20.0 * std::log10(3.0), 1e-9);
  EXPECT_NEAR(radio.meanRssi(0, {14.0, 10.0}), -30.0 - 20.0 * std::log10(5.0), 1e-9);
}

TEST(RadioModel, SamplesScatterAroundTheMeanInWholeDecibels) {
  RadioModel::Config config;
  config.sample_noise = 2.0;
  const RadioModel radio(hall(), {accessPointAt({10.0, 10.0})}, config);
  const Position antenna(17.3, 12.1);
  std::vector<double> errors;
  for (std::uint64_t sample = 0; sample < 20000; ++sample) {
    const double rssi_dbm = radio.rssi(0, antenna, sample).value();
    EXPECT_EQ(rssi_dbm, std::round(rssi_dbm));
    errors.push_back(rssi_dbm - radio.meanRssi(0, antenna));
  }
  const Moments moments = momentsOf(errors);
  EXPECT_NEAR(moments.mean, 0.0, 0.06);                               // 4 standard errors
  EXPECT_NEAR(moments.deviation, std::sqrt(4.0 + 1.0 / 12.0), 0.05);  // with the rounding's share
}

TEST(RadioModel, WallLossAndExponentAreRecoveredFromNoisySamples) {
  RadioModel::Config config;
  config.exponent = 1.7;
  config.wall_loss = 6.1;
  config.shadowing = 1.0;
  config.sample_noise = 3.0;
  config.seed = 7;
  // The access point stands at the wall's face, so all points at equal distance pair up.
  const RadioModel radio(hall(), {accessPointAt({50.0 - 1e-6, 20.0})}, config);
  double sum_h = 0, sum_hh = 0, sum_z = 0, sum_hz = 0, count = 0;
  double behind = 0.0;
  for (std::uint64_t sample = 0; sample < 40000; ++sample) {
    const double distance = 2.0 + 38.0 * static_cast<double>(sample % 400) / 400.0;
    const double aside = 0.15 * (static_cast<double>(sample / 400) - 50.0);
    const double along = std::sqrt(std::max(distance * distance - aside * aside, 0.0));
    if (along < 1.5) {
      continue;
    }
    const double before = radio.rssi(0, {50.0 - along, 20.0 + aside}, 2 * sample).value();
    const double h = 10.0 * std::log10(distance);
    sum_h += h;
    sum_hh += h * h;
    sum_z += before;
    sum_hz += h * before;
    behind += before - radio.rssi(0, {50.0 + along, 20.0 + aside}, 2 * sample + 1).value();
    count += 1;
  }
  const double slope = (count * sum_hz - sum_h * sum_z) / (count * sum_hh - sum_h * sum_h);
  EXPECT_NEAR(-slope, config.exponent, 0.1);
  EXPECT_NEAR(behind / count, config.wall_loss, 0.4);
}

TEST(RadioModel, ShadowingHasItsDeviationAndCorrelationLength) {
  RadioModel::Config config = quietRadio();
  config.shadowing = 3.0;
  config.shadowing_distance = 1.5;
  std::vector<double> here;
  double product = 0.0, far_product = 0.0;
  for (config.seed = 0; config.seed < 20; ++config.seed) {
    RadioModel::Config flat = config;
    flat.shadowing = 0.0;
    const Grid<CellState> plan(GridGeometry(1.0, Position::Zero(), 40, 40), CellState::kFree);
    const std::vector<AccessPoint> table = {accessPointAt({20.0, 20.0})};
    const RadioModel radio(plan, table, config), smooth(plan, table, flat);
    const auto shadow = [&](const Position& p) {
      return radio.meanRssi(0, p) - smooth.meanRssi(0, p);
    };
    for (int i = 0; i < 400; ++i) {
      const Position p(1.0 + 1.9 * (i % 20), 1.0 + 1.8 * (i / 20));
      here.push_back(shadow(p));
      product += shadow(p) * shadow(p + Position(0.9, 1.2));  // 1.5 m away
      far_product += shadow(p) * shadow(p + Position(-0.5, 7.5));
    }
  }
  const Moments moments = momentsOf(here);
  const double variance = moments.deviation * moments.deviation;
  const auto count = static_cast<double>(here.size());
  EXPECT_NEAR(moments.mean, 0.0, 0.3);
  EXPECT_NEAR(moments.deviation, 3.0, 0.3);
  EXPECT_NEAR(product / count / variance, std::exp(-1.0), 0.1);
  EXPECT_NEAR(far_product / count / variance, 0.0, 0.1);
}

TEST(RadioModel, DependsOnItsSeedAndArgumentsOnly) {
  const std::vector<AccessPoint> table = {accessPointAt({10, 10}),
                                          accessPointAt({10, 10}, "02:00:00:00:00:02")};
  RadioModel::Config config;
  const RadioModel radio(hall(), table, config), same(hall(), table, config);
  config.seed = 2;
  const RadioModel other(hall(), table, config);
  std::vector<double> forwards, backwards;
  int differs_by_seed = 0, differs_by_access_point = 0, differs_by_sample = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    const Position p(12.0 + 0.1 * static_cast<double>(i), 11.0);
    const Position q(12.0 + 0.1 * static_cast<double>(99 - i), 11.0);
    forwards.push_back(radio.rssi(0, p, i).value());
    backwards.insert(backwards.begin(), same.rssi(0, q, 99 - i).value());
    differs_by_seed += forwards.back() != other.rssi(0, p, i).value() ? 1 : 0;
    differs_by_access_point += forwards.back() != radio.rssi(1, p, i).value() ? 1 : 0;
    differs_by_sample += forwards.back() != radio.rssi(0, p, i + 1).value() ? 1 : 0;
  }
  EXPECT_EQ(forwards, backwards);
  EXPECT_GT(differs_by_seed, 50);
  EXPECT_GT(differs_by_access_point, 50);
  EXPECT_GT(differs_by_sample, 50);
}

TEST(RadioModel, GivesTheSameSignalsOnEveryMachine) {
  RadioModel::Config config;
  config.exponent = 1.7;
  config.shadowing = 2.5;
  config.sample_noise = 2.0;
  const RadioModel radio(hall(), {accessPointAt({10, 10})}, config);
  std::vector<double> heard;
  for (std::uint64_t i = 0; i < 8; ++i) {
    heard.push_back(radio.rssi(0, {12.0 + static_cast<double>(i), 11.0}, i).value());
  }
  EXPECT_EQ(heard, (std::vector<double>{-39, -42, -47, -41, -43, -47, -54, -50}));
}

TEST(RadioModel, DoesNotHearWhatIsTooWeak) {
  RadioModel::Config config = quietRadio();
  config.exponent = 2.0;
  config.sensitivity = -60.0;
  const RadioModel radio(hall(), {accessPointAt({10, 10})}, config);
  EXPECT_TRUE(radio.rssi(0, {15, 10}, 0).has_value());
  EXPECT_FALSE(radio.rssi(0, {95, 10}, 0).has_value());
}

TEST(RadioModel, NamesEverySettingOutOfRange) {
  RadioModel::Config config;
  config.exponent = -1.0;
  config.sample_noise = NAN;
  EXPECT_EQ(messageOf([&] {
              RadioModel(hall(), {accessPointAt({10, 80})}, config);
            }),
            "exponent must lie in 0..10\n"
            "sample_noise must lie in 0..30\n"
            "access point 02:00:00:00:00:01 at (10.00, 80.00) is outside the plan");
}

}  // namespace
}  // namespace sfw
