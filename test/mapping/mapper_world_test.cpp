#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "evaluation/evaluation.h"
#include "grid/for_each_cell.h"
#include "simulation/building/wall_crossings.h"
#include "simulation/robot/route.h"
#include "structure_from_wifi/mapper.h"
#include "support/ascii_world.h"

namespace sfw {
namespace {

/// Four rooms, 8 x 6 m about the map's origin; walls are 0.25 m thick.
const std::vector<std::string> kRooms{"################################",  //
                                      "#..............#...............#",  //
                                      "#..............#...............#",  //
                                      "#..............................#",  //
                                      "#..............................#",  //
                                      "#..............................#",  //
                                      "#..............................#",  //
                                      "#..............#...............#",  //
                                      "#..............#...............#",  //
                                      "#..............#...............#",  //
                                      "#..............#...............#",  //
                                      "###....#################....####",  //
                                      "#................#.............#",  //
                                      "#................#.............#",  //
                                      "#................#.............#",  //
                                      "#................#.............#",  //
                                      "#................#.............#",  //
                                      "#................#.............#",  //
                                      "#................#.............#",  //
                                      "#................#.............#",  //
                                      "#................#.............#",  //
                                      "#................#.............#",  //
                                      "#................#.............#",  //
                                      "################################"};
constexpr double kWallThickness = 0.25;

Grid<CellState> rooms() { return test::world(kRooms, kWallThickness, {-4.0, -3.0}); }

/// Along the walls of all rooms, 0.4 m from them, through the three doors.
std::vector<Position> wayPoints() {
  const std::vector<Position> corners{
      {-3.35, 2.35}, {-0.65, 2.35},  {-0.65, 0.65},  {-3.35, 0.65},  {-3.35, 1.75},  {0.40, 1.75},
      {0.40, 2.35},  {3.35, 2.35},   {3.35, 0.65},   {0.40, 0.65},   {0.40, 1.75},   {0.40, 0.65},
      {2.50, 0.65},  {2.50, -0.40},  {3.35, -0.40},  {3.35, -2.35},  {0.90, -2.35},  {0.90, -0.40},
      {2.50, -0.40}, {2.50, 0.65},   {0.40, 0.65},   {0.40, 1.75},   {-0.65, 1.75},  {-0.65, 0.65},
      {-2.75, 0.65}, {-2.75, -0.40}, {-0.15, -0.40}, {-0.15, -2.35}, {-3.35, -2.35}, {-3.35, -0.40},
      {-2.75, -0.40}};
  std::vector<Position> way_points;
  for (const Position& corner : corners) {
    way_points.push_back(corner + Position(0.013, 0.017));  // not on borders of cells
  }
  return way_points;
}

const std::vector<Position> kAccessPoints{{-2.03, 1.52}, {2.53, -1.48}, {2.03, 1.27}};

/// Every pose of the drive, 0.1 m apart.
std::vector<Position> drive() {
  const Route route(wayPoints(), 1.0, 1000.0);
  std::vector<Position> path;
  for (double t = 0.0; t < route.duration(); t += 0.1) {
    path.push_back(route.poseAt(t).position);
  }
  return path;
}

std::vector<AccessPoint> tableOf(const std::vector<Position>& positions) {
  std::vector<AccessPoint> table;
  for (const Position& position : positions) {
    AccessPoint access_point;
    access_point.bssid = *Bssid::parse("02:00:00:00:00:0" + std::to_string(table.size() + 1));
    access_point.position = position;
    table.push_back(access_point);
  }
  return table;
}

/// A map from signals that give exact wall counts: -30 dBm less a loss for each wall. Counts
/// come from the world as drawn; positions are moved afterwards.
template <class Move>
std::shared_ptr<const Snapshot> mapOf(Move&& move, double wall_loss_db = 10.0) {
  Config config;
  config.method = "k_visibility";
  config.belief.free_threshold = 0.35;
  config.k_visibility.path_loss_exponent = 0.0;
  config.k_visibility.window = 1;
  config.k_visibility.wall_thickness_m = kWallThickness;
  const Grid<CellState> plan = rooms();
  std::vector<Position> moved;
  for (const Position& position : kAccessPoints) {
    moved.push_back(move(position));
  }
  const std::vector<AccessPoint> table = tableOf(moved);
  Mapper mapper(config, table);
  std::int64_t stamp_ns = 0;
  for (const Position& pose : drive()) {
    stamp_ns += 100000000;
    for (std::size_t i = 0; i < table.size(); ++i) {
      const int walls = countWalls(plan, kAccessPoints[i], pose);
      mapper.insert({stamp_ns, move(pose), table[i].bssid, -30.0 - wall_loss_db * walls});
    }
  }
  return mapper.infer();
}

Grid<CellState> statesOf(const BeliefMap& belief) {
  Grid<CellState> states(belief.geometry());
  forEachCell(belief.geometry(), [&](Cell c) { states[c] = belief.state(c); });
  return states;
}

Position same(const Position& p) { return p; }

TEST(MapperInAWorld, DrivesWhereTheWorldIsFree) {
  EXPECT_NO_THROW(requireFree(rooms(), wayPoints(), 0.15));
}

TEST(MapperInAWorld, CountsEveryWallFromPerfectSignals) {
  const auto snapshot = mapOf(same);
  const Grid<CellState> plan = rooms();
  for (std::size_t i = 0; i < kAccessPoints.size(); ++i) {
    const std::vector<double>& thresholds = snapshot->access_points[i].wall_counts->thresholds_dbm;
    for (const Position& pose : drive()) {
      const int walls = countWalls(plan, kAccessPoints[i], pose);
      const double rssi_dbm = -30.0 - 10.0 * walls;
      ASSERT_EQ(std::count_if(thresholds.begin(), thresholds.end(),
                              [&](double threshold) { return threshold >= rssi_dbm; }),
                walls);
    }
  }
}

TEST(MapperInAWorld, FindsItsFreeSpaceAndWalls) {
  const auto snapshot = mapOf(same);
  const Evaluation evaluation =
      evaluate({statesOf(snapshot->belief), rooms(), drive(), kAccessPoints, std::nullopt});
  const MapMetrics& figures = evaluation.map;
  // Perfect counts never free a cell of a wall.
  EXPECT_GE(figures.free.precision, 0.995);
  EXPECT_LE(*figures.observed_walls_called_free, 0.005);
  // The strip of 0.25 m between the robot's footprint and the walls stays unseen: that leaves 27.3
  // of 38.9 m2. Less than a fiftieth of them may be lost; doors add a little.
  EXPECT_GE(figures.free.recall, 0.98 * 27.3 / 38.9);
  // A wall of 0.25 m lies somewhere in the 0.75 m between two footprints, which are drawn occupied.
  // With the tolerance of 0.1 m on either side 0.45 m of them count, less a tenth for the rims.
  EXPECT_GE(figures.wall_two_cells->precision, 0.9 * 0.45 / 0.75);
  EXPECT_GE(*figures.wall_two_cells->observed_recall, 0.98);
  // The path alone, closed, takes walls for free space.
  EXPECT_GT(figures.free.precision, evaluation.path_only.free.precision + 0.05);
  EXPECT_GT(*evaluation.path_only.observed_walls_called_free, 0.2);
}

TEST(MapperInAWorld, LosesItsWallsWithoutTheRadio) {
  // The control: the same drive with one signal everywhere counts no wall anywhere.
  const auto snapshot = mapOf(same, 0.0);
  EXPECT_EQ(snapshot->access_points.front().wall_counts->walls(), 0U);
  const Evaluation evaluation =
      evaluate({statesOf(snapshot->belief), rooms(), drive(), kAccessPoints, std::nullopt});
  EXPECT_GE(*evaluation.map.observed_walls_called_free, 0.5);
  EXPECT_EQ(*evaluation.map.wall_two_cells->observed_recall, 0.0);
}

/// The share of the cells known in either map whose state differs between a map and the map of the
/// moved world.
template <class Move>
double differingShare(Move&& move) {
  const auto snapshot = mapOf(same);
  const auto moved = mapOf(move);
  const GridGeometry& geometry = snapshot->belief.geometry();
  std::size_t known = 0;
  std::size_t different = 0;
  forEachCell(geometry, [&](Cell c) {
    const CellState here = snapshot->belief.state(c);
    const Cell there = moved->belief.geometry().cellAt(move(geometry.centre(c)));
    const CellState moved_state = moved->belief.state(there);
    const bool either = here != CellState::kUnknown || moved_state != CellState::kUnknown;
    known += either ? 1 : 0;
    different += here != moved_state ? 1 : 0;
  });
  EXPECT_GT(known, 1000U);
  return static_cast<double>(different) / static_cast<double>(known);
}

// Moved sums are rounded otherwise in their last bits, which now and then moves a probability over
// a threshold.
constexpr double kRoundingShare = 0.001;

TEST(MapperInAWorld, MapsAMirroredWorldMirrored) {
  EXPECT_LE(differingShare([](const Position& p) { return Position(-p.x(), p.y()); }),
            kRoundingShare);
}

TEST(MapperInAWorld, MapsARotatedWorldRotated) {
  EXPECT_LE(differingShare([](const Position& p) { return Position(-p.y(), p.x()); }),
            kRoundingShare);
}

TEST(MapperInAWorld, MapsAWorldMovedBySteps) {
  EXPECT_LE(differingShare([](const Position& p) { return Position(p.x() + 80.0, p.y() - 16.0); }),
            kRoundingShare);
}

}  // namespace
}  // namespace sfw
