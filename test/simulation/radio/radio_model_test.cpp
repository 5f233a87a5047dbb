#include "simulation/radio/radio_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "structure_from_wifi/input_error.h"
#include "support/radio_hall.h"

namespace sfw {
namespace {

using test::accessPointAt;
using test::dividedHall;
using test::emptyHall;
using test::oneAt;
using test::quietRadio;

std::string messageOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no error";
}

RobotPose at(double x, double y, double yaw_rad = 0.0) { return {{x, y}, yaw_rad}; }

// ---- Path loss ----

TEST(RadioModel, LosesByDistanceAndWalls) {
  RadioModel::Config config = quietRadio();
  config.rssi_at_1m_dbm = -30.0;
  config.exponent = 2.0;
  config.interior_wall_loss_db = 6.0;
  const RadioModel radio(dividedHall(), oneAt({45.0, 20.0}), config);
  EXPECT_NEAR(radio.meanRssi(0, at(44, 20)), -30.0, 1e-9);
  EXPECT_NEAR(radio.meanRssi(0, at(35, 20)), -50.0, 1e-9);
  EXPECT_NEAR(radio.meanRssi(0, at(55, 20)), -56.0, 1e-9);
  EXPECT_NEAR(*radio.rssi(0, at(35, 20), 0), -50.0, 1e-9);
  EXPECT_LE(*radio.rssi(0, at(45, 20), 0), 0.0);  // on the access point itself
  EXPECT_EQ(radio.wallCount(0, {55, 20}), 1);
}

TEST(RadioModel, AnAccessPointOnTheCeilingIsNeverNear) {
  RadioModel::Config config = quietRadio();
  config.rssi_at_1m_dbm = -30.0;
  config.exponent = 2.0;
  config.antenna_height_m = 0.5;
  AccessPoint access_point = accessPointAt({10.0, 10.0});
  access_point.height_m = 3.5;
  const RadioModel radio(emptyHall(), asTransmitters({access_point}), config);
  EXPECT_NEAR(radio.meanRssi(0, at(10, 10)), -30.0 - 20.0 * std::log10(3.0), 1e-9);
  EXPECT_NEAR(radio.meanRssi(0, at(14, 10)), -30.0 - 20.0 * std::log10(5.0), 1e-9);
}

TEST(RadioModel, SendsWithThePowerOfItsAccessPoint) {
  AccessPoint weak = accessPointAt({10.0, 10.0});
  weak.tx_dbm = 14.0;
  const RadioModel radio(emptyHall(), asTransmitters({weak}), quietRadio());
  EXPECT_NEAR(radio.meanRssi(0, at(11, 10)), quietRadio().rssi_at_1m_dbm - 6.0, 1e-9);
}

// ---- Walls ----

TEST(RadioModel, OuterWallsLoseMoreAndEachBandHasItsLosses) {
  RadioModel::Config config = quietRadio();
  config.interior_wall_loss_db = 6.0;
  config.outer_wall_loss_db = 13.0;
  FloorPlan plan = dividedHall();
  test::buildWall(plan, 60.0, 0.3, Material::kOuterWall);
  const Transmitter slow{accessPointAt({45, 20}), Band::k2400MHz};
  const Transmitter fast{accessPointAt({45, 20}), Band::k5000MHz};
  const RadioModel radio(plan, {slow, fast}, config);
  const BandFigures on_5_ghz = bandFigures(Band::k5000MHz);
  EXPECT_NEAR(radio.obstacleLoss(0, {55, 20}), 6.0, 1e-9);
  EXPECT_NEAR(radio.obstacleLoss(0, {65, 20}), 19.0, 1e-9);
  EXPECT_NEAR(radio.obstacleLoss(1, {55, 20}), 6.0 * on_5_ghz.interior_wall_factor, 1e-9);
  EXPECT_NEAR(radio.obstacleLoss(1, {65, 20}),
              6.0 * on_5_ghz.interior_wall_factor + 13.0 * on_5_ghz.outer_wall_factor, 1e-9);
  EXPECT_NEAR(radio.meanRssi(0, at(46, 20)) - radio.meanRssi(1, at(46, 20)),
              20.0 * std::log10(frequencyMhz(Band::k5000MHz) / frequencyMhz(Band::k2400MHz)), 0.01);
}

TEST(RadioModel, LossesSaturate) {
  RadioModel::Config config = quietRadio();
  config.interior_wall_loss_db = 8.0;
  config.max_obstacle_loss_db = 15.0;
  FloorPlan plan = emptyHall();
  for (int i = 1; i <= 9; ++i) {
    test::buildWall(plan, 10.0 * i, 0.2, Material::kInteriorWall);
  }
  const RadioModel radio(plan, oneAt({5.0, 20.0}), config);
  for (int walls = 0; walls <= 9; ++walls) {
    EXPECT_NEAR(radio.obstacleLoss(0, {5.0 + 10.0 * walls, 20.0}),
                15.0 * (1.0 - std::exp(-8.0 * walls / 15.0)), 1e-9);
  }
}

TEST(RadioModel, AWallsLossBelongsToItsPlaceNotToTheRay) {
  RadioModel::Config config = quietRadio();
  config.interior_wall_variation_db = 2.0;
  FloorPlan plan = emptyHall();
  test::buildWall(plan, 50.0, 0.1, Material::kInteriorWall);
  const std::vector<Transmitter> table =
      asTransmitters({accessPointAt({45.05, 20.05}), accessPointAt({45.05, 15.05})});
  const RadioModel radio(plan, table, config);
  // Both rays go through the wall at (50.05, 20.05).
  EXPECT_NEAR(radio.obstacleLoss(0, {55.05, 20.05}), radio.obstacleLoss(1, {55.05, 25.05}), 1e-9);
  EXPECT_GT(std::abs(radio.obstacleLoss(0, {55.05, 20.05}) - config.interior_wall_loss_db), 1e-3);
}

TEST(RadioModel, WallsNeverStrengthenASignal) {
  RadioModel::Config config = quietRadio();
  config.interior_wall_loss_db = 1.0;
  config.interior_wall_variation_db = 5.0;
  const RadioModel radio(dividedHall(), oneAt({45.0, 20.0}), config);
  for (double y = 1.0; y < 40.0; y += 0.7) {
    EXPECT_GE(radio.obstacleLoss(0, {55.0, y}), 0.0);
  }
}

TEST(RadioModel, FurnitureWeakensSignalsAndSaturatesWithTheWalls) {
  RadioModel::Config config = quietRadio();
  config.max_furniture_loss_db = 5.0;
  config.max_obstacle_loss_db = 15.0;
  const RadioModel radio(dividedHall(), oneAt({45.0, 20.0}), config);
  const std::vector<Furniture> pieces = placeFurniture(dividedHall(), 5.0, 9.0, config.seed);
  EXPECT_EQ(pieces.size(), 440U);  // 99 x 40 m of free space
  const Position place(52.5, 3.0);
  const double sum = config.interior_wall_loss_db + furnitureLoss(pieces, {45, 20}, place);
  EXPECT_GT(sum, config.interior_wall_loss_db);
  EXPECT_NEAR(radio.obstacleLoss(0, place), 15.0 * (1.0 - std::exp(-sum / 15.0)), 1e-9);
}

// ---- Samples ----

TEST(RadioModel, SignalsAreWholeSteps) {
  for (const double step : {1.0, 2.0}) {
    RadioModel::Config config;
    config.rssi_step_db = step;
    const RadioModel radio(emptyHall(), oneAt({10, 10}), config);
    for (std::uint64_t sample = 0; sample < 200; ++sample) {
      const double steps = *radio.rssi(0, at(17.3, 12.1), sample) / step;
      EXPECT_EQ(steps, std::round(steps));
    }
  }
}

TEST(RadioModel, WithoutAStepSignalsAreNotRounded) {
  RadioModel::Config config = quietRadio();
  const RadioModel radio(emptyHall(), oneAt({10, 10}), config);
  EXPECT_EQ(*radio.rssi(0, at(17.3, 12.1), 4), radio.meanRssi(0, at(17.3, 12.1)));
}

TEST(RadioModel, DoesNotHearWhatIsTooWeak) {
  RadioModel::Config config = quietRadio();
  config.exponent = 2.0;
  config.sensitivity_dbm = -60.0;
  const RadioModel radio(emptyHall(), oneAt({10, 10}), config);
  EXPECT_TRUE(radio.rssi(0, at(15, 10), 0).has_value());
  EXPECT_FALSE(radio.rssi(0, at(95, 10), 0).has_value());
}

TEST(RadioModel, DependsOnItsSeedAndArgumentsOnly) {
  const std::vector<Transmitter> table =
      asTransmitters({accessPointAt({10, 10}), accessPointAt({10, 10}, "02:00:00:00:00:02")});
  RadioModel::Config config;
  config.max_furniture_loss_db = 5.0;
  config.robot_pattern_db = config.access_point_pattern_db = 2.0;
  config.missed_share = 0.1;
  const RadioModel radio(dividedHall(), table, config), same(dividedHall(), table, config);
  config.seed = 2;
  const RadioModel other(dividedHall(), table, config);
  std::vector<std::optional<double>> forwards, backwards;
  int differs_by_seed = 0, differs_by_access_point = 0, differs_by_sample = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    const RobotPose p = at(12.0 + 0.1 * static_cast<double>(i), 11.0, 0.05);
    const RobotPose q = at(12.0 + 0.1 * static_cast<double>(99 - i), 11.0, 0.05);
    forwards.push_back(radio.rssi(0, p, i));
    backwards.insert(backwards.begin(), same.rssi(0, q, 99 - i));
    differs_by_seed += forwards.back() != other.rssi(0, p, i) ? 1 : 0;
    differs_by_access_point += forwards.back() != radio.rssi(1, p, i) ? 1 : 0;
    differs_by_sample += forwards.back() != radio.rssi(0, p, i + 1) ? 1 : 0;
  }
  EXPECT_EQ(forwards, backwards);
  EXPECT_GT(differs_by_seed, 50);
  EXPECT_GT(differs_by_access_point, 50);
  EXPECT_GT(differs_by_sample, 50);
}

TEST(RadioModel, GivesTheSameSignalsOnEveryMachine) {
  RadioModel::Config config;
  config.exponent = 1.7;
  const RadioModel radio(dividedHall(), oneAt({10, 10}), config);
  std::vector<double> heard;
  for (std::uint64_t i = 0; i < 8; ++i) {
    heard.push_back(radio.rssi(0, at(12.0 + static_cast<double>(i), 11.0), i).value());
  }
  EXPECT_EQ(heard, (std::vector<double>{-44, -45, -39, -40, -40, -45, -44, -48}));
}

TEST(RadioModel, NamesEverySettingOutOfRange) {
  RadioModel::Config config;
  config.exponent = -1.0;
  config.sample_noise_db = NAN;
  config.missed_share = 1.5;
  EXPECT_EQ(messageOf([&] {
              RadioModel(emptyHall(), oneAt({10, 80}), config);
            }),
            "exponent must lie in 0..10; it is -1\n"
            "sample_noise must lie in 0..30; it is nan\n"
            "missed must lie in 0..1; it is 1.5\n"
            "access point 02:00:00:00:00:01 at (10.00, 80.00) is outside the plan");
}

}  // namespace
}  // namespace sfw
