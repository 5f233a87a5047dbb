#include "mapping/fused_belief.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/constants.h"
#include "evaluation/ablations.h"
#include "simulation/building/floor_plan_generator.h"
#include "simulation/scenario.h"
#include "structure_from_wifi/map_files.h"
#include "structure_from_wifi/mapper.h"

namespace sfw::test {
namespace {

/// A drive along the walls of a made-up flat.
struct World {
  FloorPlan plan;
  std::vector<AccessPoint> access_points;
  std::vector<Reading> readings;
};

World flat(NoiseLevel level, std::int64_t seed) {
  BuildingConfig building;
  building.seed = static_cast<std::uint64_t>(seed);
  building.area_m2 = 60.0;
  ScenarioConfig config;
  config.noise = level;
  config.seed = seed;
  config.access_points = 2;
  const Scenario scenario = makeScenario(generateFloorPlan(building), {}, config);
  return {scenario.plan, scenario.access_points, simulate(scenario).readings};
}

/// The world after x -> -y, y -> x, or the like.
World moved(World world, const Eigen::Matrix2d& move) {
  for (Reading& reading : world.readings) {
    reading.antenna_in_map = move * reading.antenna_in_map;
  }
  for (AccessPoint& access_point : world.access_points) {
    access_point.position = move * access_point.position;
  }
  return world;
}

std::shared_ptr<const Snapshot> mapOf(const World& world, const Config& config = {}) {
  Mapper mapper(config, world.access_points);
  for (const Reading& reading : world.readings) {
    mapper.insert(reading);
  }
  return mapper.infer();
}

Evaluation judged(const World& world, const Snapshot& snapshot) {
  EvaluationInput input{toStates(world.plan), toStates(world.plan), {}, {}, {}};
  setMap(snapshot, input);
  for (const Reading& reading : world.readings) {
    input.path.push_back(reading.antenna_in_map);
  }
  for (const AccessPoint& access_point : world.access_points) {
    input.access_points.push_back(access_point.position);
  }
  return evaluate(input);
}

TEST(Tomography, FindsFreeSpaceAndHearsWallsInAFlat) {
  const World world = flat(noiseLevel("moderate"), 11);
  const auto snapshot = mapOf(world);
  const Evaluation evaluation = judged(world, *snapshot);
  EXPECT_GE(evaluation.map.free.precision, 0.9);
  EXPECT_GE(evaluation.map.free.iou, 0.75);
  EXPECT_GE(*evaluation.map.radio->auc, 0.9);
  EXPECT_GE(*evaluation.map.radio->auc_off_path, 0.7);
  EXPECT_EQ(snapshot->tomography->style.along_walls, 1.0);
  EXPECT_EQ(snapshot->tomography->style.patrol, 0.0);
  EXPECT_EQ(snapshot->tomography->style.stroll, 0.0);
}

TEST(Tomography, HearsNothingInSignalsAtWrongPlaces) {
  World world = flat(noiseLevel("moderate"), 11);
  const double heard = *judged(world, *mapOf(world)).map.radio->auc_off_path;
  world.readings = withShiftedRadio(world.readings, 4);
  EXPECT_LT(*judged(world, *mapOf(world)).map.radio->auc_off_path, heard - 0.1);
}

TEST(Tomography, ANetworkClosesWallsThatCellsLeaveOpen) {
  const World world = flat(noiseLevel("moderate"), 11);
  Config config;
  config.belief.walls = "none";
  const Evaluation cells = judged(world, *mapOf(world, config));
  const Evaluation walls = judged(world, *mapOf(world));
  EXPECT_LT(*walls.map.walls_called_free, 0.8 * *cells.map.walls_called_free);
  EXPECT_GT(walls.map.free.precision, cells.map.free.precision - 0.005);
}

/// Whether all segments lie along the axes of the building, within rounding errors.
bool followAxes(const std::vector<WallSegment>& walls, double building_yaw_rad) {
  return std::all_of(walls.begin(), walls.end(), [&](const WallSegment& wall) {
    const Position along = wall.to - wall.from;
    const double quarter_turns =
        (std::atan2(along.y(), along.x()) - building_yaw_rad) / (0.5 * kPi);
    return std::abs(quarter_turns - std::round(quarter_turns)) < 1e-9;
  });
}

TEST(Tomography, ReportsWallsOfTheNetworkAsSegments) {
  const World world = flat(noiseLevel("moderate"), 11);
  Config config;
  config.belief.walls = "none";
  EXPECT_TRUE(mapOf(world, config)->walls.empty());
  const Eigen::Matrix2d slanted = Eigen::Rotation2Dd(0.5).toRotationMatrix();
  for (const World& one : {world, moved(world, slanted)}) {
    const auto snapshot = mapOf(one);
    ASSERT_FALSE(snapshot->walls.empty());
    EXPECT_TRUE(followAxes(snapshot->walls, snapshot->tomography->building_yaw_rad));
    double length_m = 0.0;
    double free_m = 0.0;
    double occupied_m[2] = {0.0, 0.0};  // by is_outer
    for (const WallSegment& wall : snapshot->walls) {
      EXPECT_GT(wall.confidence, 0.0);
      EXPECT_LT(wall.confidence, 1.0);
      const double metres = (wall.to - wall.from).norm();
      const Cell middle = snapshot->belief.geometry().cellAt(0.5 * (wall.from + wall.to));
      length_m += metres;
      free_m += snapshot->belief.state(middle) == CellState::kFree ? metres : 0.0;
      occupied_m[wall.is_outer] +=
          snapshot->belief.state(middle) == CellState::kOccupied ? metres : 0.0;
    }
    EXPECT_GT(length_m, 1.0);
    EXPECT_LT(free_m, 0.1 * length_m);  // the map shows the same walls
    EXPECT_GT(occupied_m[false], 0.2 * length_m);
    EXPECT_LT(occupied_m[true], 0.1 * occupied_m[false]);  // outer walls are segments only
  }
}

TEST(Tomography, DoesNotDependOnTheOrderOfReadings) {
  World world = flat(noiseLevel("realistic"), 12);
  const std::string sorted = probabilityPgm(mapOf(world)->probability);
  std::mt19937 random(3);
  std::shuffle(world.readings.begin(), world.readings.end(), random);
  EXPECT_EQ(probabilityPgm(mapOf(world)->probability), sorted);
}

/// Share of the cells that are free in either map and in both.
double agreement(const BeliefMap& map, const BeliefMap& moved, const Eigen::Matrix2d& move) {
  double both = 0.0;
  double either = 0.0;
  for (std::size_t i = 0; i < map.geometry().size(); ++i) {
    const Cell c = map.geometry().cell(i);
    const Cell there = moved.geometry().cellAt(move * map.geometry().centre(c));
    const bool here_free = map.state(c) == CellState::kFree;
    const bool there_free =
        moved.geometry().contains(there) && moved.state(there) == CellState::kFree;
    both += here_free && there_free ? 1.0 : 0.0;
    either += here_free || there_free ? 1.0 : 0.0;
  }
  return both / either;
}

TEST(Tomography, TurnsAndMirrorsWithTheWorld) {
  const World world = flat(noiseLevel("realistic"), 13);
  const auto map = mapOf(world);
  Eigen::Matrix2d quarter_turn;
  quarter_turn << 0.0, -1.0, 1.0, 0.0;
  Eigen::Matrix2d mirror;
  mirror << -1.0, 0.0, 0.0, 1.0;
  const Eigen::Matrix2d slanted = Eigen::Rotation2Dd(0.5).toRotationMatrix();
  // Lattices and the bins left out do not turn along: the average over them does, nearly.
  for (const Eigen::Matrix2d& move : {quarter_turn, mirror, slanted}) {
    EXPECT_GE(agreement(map->belief, mapOf(moved(world, move))->belief, move), 0.93) << move;
  }
}

// ---- Little to go by ----

void expectValid(const Snapshot& snapshot) {
  const GridGeometry& geometry = snapshot.belief.geometry();
  std::size_t unknown = 0;
  for (std::size_t i = 0; i < geometry.size(); ++i) {
    const Cell c = geometry.cell(i);
    ASSERT_TRUE(std::isfinite(snapshot.belief.occupied(c)));
    unknown += snapshot.belief.state(c) == CellState::kUnknown ? 1 : 0;
  }
  EXPECT_GT(static_cast<double>(unknown), 0.8 * static_cast<double>(geometry.size()));
}

AccessPoint accessPoint() {
  AccessPoint access_point;
  access_point.bssid = numberedBssid(1);
  access_point.position = {4.0, 4.0};
  return access_point;
}

Reading readingAt(double x, double y, double rssi_dbm, std::int64_t second,
                  const Bssid& bssid = numberedBssid(1)) {
  return {second * 1000000000, {x, y}, bssid, rssi_dbm};
}

TEST(Tomography, GivesAMostlyUnknownMapWithoutReadings) {
  const auto snapshot = mapOf({FloorPlan(GridGeometry(0.1, {0, 0}, 1, 1)), {accessPoint()}, {}});
  expectValid(*snapshot);
}

TEST(Tomography, GivesAMostlyUnknownMapOfOneReading) {
  const auto snapshot = mapOf({FloorPlan(GridGeometry(0.1, {0, 0}, 1, 1)),
                               {accessPoint()},
                               {readingAt(2.0, 2.0, -50.0, 1)}});
  expectValid(*snapshot);
  EXPECT_EQ(snapshot->belief.state(snapshot->belief.geometry().cellAt({2.0, 2.0})),
            CellState::kFree);
}

TEST(Tomography, SurvivesAStraightPathWithReadingsAllAlike) {
  World world{FloorPlan(GridGeometry(0.1, {0, 0}, 1, 1)), {accessPoint()}, {}};
  for (int i = 0; i < 60; ++i) {
    world.readings.push_back(readingAt(0.1 * i, 2.0, -50.0, i));
  }
  expectValid(*mapOf(world));
}

TEST(Tomography, MapsThePathWhenNoAccessPointIsKnown) {
  World world{FloorPlan(GridGeometry(0.1, {0, 0}, 1, 1)), {accessPoint()}, {}};
  for (int i = 0; i < 60; ++i) {
    world.readings.push_back(readingAt(0.1 * i, 2.0, -50.0, i, numberedBssid(9)));
  }
  const auto snapshot = mapOf(world);
  expectValid(*snapshot);
  EXPECT_EQ(snapshot->belief.state(snapshot->belief.geometry().cellAt({3.0, 2.0})),
            CellState::kFree);
  EXPECT_EQ(snapshot->rejections.unknown_access_points.at(numberedBssid(9)), 60U);
}

TEST(Tomography, KeepsWhatTheRobotTouchedOccupiedUntilItDrivesOverIt) {
  const World world = flat(noiseLevel("moderate"), 11);
  Mapper mapper(Config(), world.access_points);
  for (const Reading& reading : world.readings) {
    mapper.insert(reading);
  }
  const Reading& first = world.readings.front();
  const Position touched_first = world.readings[world.readings.size() / 2].antenna_in_map;
  const Position touched_last = world.readings[world.readings.size() / 3].antenna_in_map;
  mapper.insert(Contact{first.stamp_ns, touched_first});
  mapper.insert(Contact{world.readings.back().stamp_ns, touched_last});
  const auto snapshot = mapper.infer();
  const auto stateAt = [&](const Position& position) {
    return snapshot->belief.state(snapshot->belief.geometry().cellAt(position));
  };
  EXPECT_EQ(stateAt(touched_first), CellState::kFree);
  EXPECT_EQ(stateAt(touched_last), CellState::kOccupied);
}

}  // namespace
}  // namespace sfw::test
