#include "structure_from_wifi/mapper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <random>
#include <string>

#include "support/mapper_scene.h"

namespace sfw {
namespace {

using namespace test;

// ---- A function of the set of readings ----

TEST(Mapper, GivesTheSameMapInAnyOrderAndWithRepetition) {
  std::vector<Reading> readings = drive();
  const std::uint64_t sorted = hashOf(mapperOf(readings));
  std::mt19937 random(8);
  for (int round = 0; round < 5; ++round) {
    std::shuffle(readings.begin(), readings.end(), random);
    EXPECT_EQ(hashOf(mapperOf(readings)), sorted);
  }
  const std::vector<Reading> once = readings;
  readings.insert(readings.end(), once.begin(), once.end());
  EXPECT_EQ(hashOf(mapperOf(readings)), sorted);
  EXPECT_EQ(mapperOf(readings).readings().size(), drive().size());
}

TEST(Mapper, GivesTheSameMapFromItsOwnReadings) {
  const Mapper mapper = mapperOf(drive());
  EXPECT_EQ(hashOf(mapperOf(mapper.readings())), hashOf(mapper));
}

TEST(Mapper, IgnoresTheLastBitsOfPositionsAndSignals) {
  std::vector<Reading> readings = drive();
  for (Reading& one : readings) {
    one.antenna_in_map += Position(1e-9, -1e-9);
    one.rssi_dbm += 1e-9;
  }
  EXPECT_EQ(hashOf(mapperOf(readings)), hashOf(mapperOf(drive())));
}

TEST(Mapper, KeepsTheStrongestOfARadioThatAScanNamesTwice) {
  const std::vector<Reading> readings =
      mapperOf({reading(1, 1, 1, -70), reading(1, 1, 1, -50), reading(1, 1, 1, -60),
                reading(1, 1, 1, -65, 2), reading(2, 1, 1, -80)})
          .readings();
  ASSERT_EQ(readings.size(), 3U);
  EXPECT_EQ(readings[0].rssi_dbm, -50.0);
  EXPECT_EQ(readings[1].rssi_dbm, -65.0);
  EXPECT_EQ(readings[2].rssi_dbm, -80.0);
}

// ---- Life ----

TEST(Mapper, StartsAllUnknownAroundItsAccessPoints) {
  const Mapper mapper(rawConfig(), {accessPoint(1, 3.0, -2.0)});
  EXPECT_EQ(mapper.geometry(), GridGeometry(0.1, {0.0, -8.0}, 80, 80));
  const auto snapshot = mapper.infer();
  EXPECT_TRUE(snapshot->path.empty());
  EXPECT_EQ(snapshot->access_points.front().readings, 0U);
  EXPECT_EQ(snapshot->access_points.front().wall_counts->walls(), 0U);
  const std::string pgm = trinaryPgm(snapshot->belief);
  EXPECT_EQ(std::count(pgm.begin(), pgm.end(), static_cast<char>(205)), 80 * 80);
}

TEST(Mapper, ForgetsAllButItsGeometryOnReset) {
  Mapper mapper = mapperOf(drive());
  mapper.insert(Contact{0, {1.0, 17.0}});
  mapper.insert(reading(1, 0, 0, 70));
  const GridGeometry geometry = mapper.geometry();
  mapper.reset();
  EXPECT_EQ(mapper.geometry(), geometry);
  EXPECT_TRUE(mapper.readings().empty());
  EXPECT_TRUE(mapper.rejections().count.empty());
  const std::string pgm = trinaryPgm(mapper.infer()->belief);
  EXPECT_EQ(static_cast<std::size_t>(std::count(pgm.begin(), pgm.end(), static_cast<char>(205))),
            geometry.size());
}

TEST(Mapper, GrowsByWholeSteps) {
  Mapper mapper(rawConfig(), {accessPoint(1, 4.0, 4.0)});
  EXPECT_EQ(mapper.geometry(), GridGeometry(0.1, {0.0, 0.0}, 80, 80));
  mapper.insert(reading(1, 6.5, 4.0, -40));
  EXPECT_EQ(mapper.geometry(), GridGeometry(0.1, {0.0, 0.0}, 80, 80));
  mapper.insert(reading(2, 7.5, 4.0, -40));  // its margin of 1 m passes the edge
  EXPECT_EQ(mapper.geometry(), GridGeometry(0.1, {0.0, 0.0}, 160, 80));
  mapper.insert(Contact{3, {4.0, -9.5}});
  EXPECT_EQ(mapper.geometry(), GridGeometry(0.1, {0.0, -16.0}, 160, 240));
}

TEST(Mapper, CountsAnUnknownAccessPointsPoseAsPath) {
  Mapper mapper(rawConfig(), {accessPoint(1, 0.5, 0.5)});
  EXPECT_EQ(mapper.insert(reading(1, 5.05, 5.05, -40, 7)), InsertResult::kUnknownAccessPoint);
  EXPECT_EQ(mapper.insert(reading(2, 5.05, 5.05, -40, 7)), InsertResult::kUnknownAccessPoint);
  const auto snapshot = mapper.infer();
  ASSERT_EQ(snapshot->path.size(), 2U);
  EXPECT_EQ(snapshot->path.front().walls, PathPose::kNoWallCount);
  EXPECT_EQ(stateAt(*snapshot, {5.05, 5.05}), CellState::kFree);
  EXPECT_EQ(stateAt(*snapshot, {2.5, 2.5}), CellState::kUnknown);
  EXPECT_EQ(snapshot->rejections.unknown_access_points.at(bssid(7)), 2U);
}

TEST(Mapper, ReportsThePathInTheOrderDrivenWithItsFewestWalls) {
  const auto snapshot =
      mapperOf({reading(3, 3, 1, -60), reading(1, 1, 1, -40), reading(2, 2, 1, -60),
                reading(2, 2, 1, -30, 2), reading(1, 1, 1, -50, 2)})
          .infer();
  ASSERT_EQ(snapshot->path.size(), 3U);
  EXPECT_EQ(snapshot->path[0].stamp_ns, 1000000000);
  EXPECT_EQ(snapshot->path[0].walls, 0);
  EXPECT_EQ(snapshot->path[1].walls, 0);  // one wall to the first, none to the second
  EXPECT_EQ(snapshot->path[2].walls, 1);
  EXPECT_EQ(snapshot->access_points[0].readings, 3U);
  EXPECT_EQ(snapshot->access_points[0].wall_counts->walls(), 1U);
}

TEST(Mapper, FreesTheCellUnderARobotOnTheAccessPoint) {
  Mapper mapper(rawConfig(), {accessPoint(1, 1.0, 1.0)});
  mapper.insert(reading(1, 1.0, 1.0, 0.0));
  const auto snapshot = mapper.infer();
  EXPECT_EQ(stateAt(*snapshot, {1.0, 1.0}), CellState::kFree);
  EXPECT_EQ(snapshot->path.front().walls, 0);
}

TEST(Mapper, InfersItsLastMapWithoutKeepingReadings) {
  const std::atomic<bool> never{false};
  Mapper mapper = mapperOf(drive());
  const std::uint64_t map = hashOf(*mapper.infer());
  EXPECT_EQ(hashOf(*mapper.inferLast(never)), map);
  EXPECT_TRUE(mapper.readings().empty());
}

TEST(Mapper, TakesAllReadingsWhateverRoomIsMade) {
  const std::vector<Reading> readings = drive();
  Mapper mapper = mapperOf({});
  mapper.reserve(readings.size() / 2);
  for (const Reading& one : readings) {
    mapper.insert(one);
  }
  EXPECT_EQ(hashOf(mapper), hashOf(mapperOf(readings)));
}

TEST(Mapper, ReturnsNothingWhenStopped) {
  const std::atomic<bool> stop{true};
  EXPECT_EQ(mapperOf(drive()).infer(stop), nullptr);
}

TEST(Mapper, RecoversFromManyWrongReadings) {
  // A million readings count a wall between two places; a few more than as many count none.
  constexpr std::int64_t kWrong = 1'000'000;
  Mapper mapper(rawConfig(), {accessPoint(1, 0.05, 1.05)});
  mapper.insert(reading(0, 1.05, 1.05, -40));
  const Position between(3.0, 1.05);
  std::int64_t stamp = 1;
  for (; stamp <= kWrong; ++stamp) {
    mapper.insert(reading(stamp, 5.05, 1.05, -60));
  }
  EXPECT_NE(stateAt(*mapper.infer(), between), CellState::kFree);
  for (; stamp <= 2 * kWrong + kWrong / 40; ++stamp) {
    mapper.insert(reading(stamp, 5.05, 1.05, -40));
  }
  EXPECT_EQ(stateAt(*mapper.infer(), between), CellState::kFree);
}

// ---- Golden ----

TEST(Mapper, MakesTheSameMapOnEveryMachine) {
  // A spiral of whole centimetres with whole decibels. If a change of the method is meant to change
  // maps, put the new hash here and say so in the change log.
  Config config;
  config.method = "k_visibility";
  config.belief.free_threshold = 0.35;
  config.k_visibility.path_loss_exponent = 0.0;
  Mapper mapper(config, {accessPoint(1, 0, 0), accessPoint(2, 3, 2)});
  std::int64_t x = -53;
  std::int64_t y = 7;
  for (int i = 0; i < 600; ++i) {
    const int side = (i / 40) % 4;
    const std::int64_t step = 3 + i / 40;
    x += side == 0 ? step : side == 2 ? -step : 0;
    y += side == 1 ? step : side == 3 ? -step : 0;
    const double at_x = static_cast<double>(x) / 100.0;
    const double at_y = static_cast<double>(y) / 100.0;
    mapper.insert(reading(i, at_x, at_y, -40 - 12 * (i / 97 % 3)));
    mapper.insert(reading(i, at_x, at_y, -45 - 11 * (i / 71 % 2), 2));
  }
  const auto snapshot = mapper.infer();
  const std::string pgm = trinaryPgm(snapshot->belief);
  EXPECT_GT(std::count(pgm.begin(), pgm.end(), static_cast<char>(254)), 1000);
  EXPECT_GT(std::count(pgm.begin(), pgm.end(), static_cast<char>(0)), 100);
  EXPECT_EQ(hashOf(pgm), 16082978119059413815U);
}

}  // namespace
}  // namespace sfw
