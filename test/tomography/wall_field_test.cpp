#include "tomography/wall_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/constants.h"
#include "grid/distance_transform.h"
#include "grid/for_each_cell.h"
#include "support/radio_walls.h"

namespace sfw {
namespace {

using test::binsThrough;
using test::coveredBy;
using test::placesAlong;
using test::StraightWall;

const std::atomic<bool> kNever{false};
const double kAddUp = std::numeric_limits<double>::infinity();
const GridGeometry kHall(0.1, {-4.0, -4.0}, 80, 80);
constexpr double kRadius = 0.2;

/// What one robot hears, and its path.
struct World {
  std::vector<AccessPointBins> access_points;
  std::vector<Position> places;
};

/// Two rooms that a wall divides up to a door in it, with a robot that visits both.
World twoRooms(double noise_db = 0.0) {
  World world;
  world.places = placesAlong({{-1.7, -3.1},
                              {-1.7, 3.1},
                              {0.5, 3.1},
                              {0.5, -3.1},
                              {1.7, -3.1},
                              {1.7, 3.1},
                              {3.1, 3.1},
                              {3.1, -3.1}});
  const std::vector<StraightWall> walls{{true, -0.5, -4.0, 1.5, 7.0}};
  for (const Position& access_point : {Position(-3.1, 0.3), Position(-2.7, -2.9)}) {
    world.access_points.push_back(binsThrough(walls, access_point, world.places, 15.0, noise_db));
  }
  return world;
}

template <class Move>
World moved(World world, Move&& move) {
  for (AccessPointBins& one : world.access_points) {
    one.position = move(one.position);
    for (RadioBin& bin : one.bins) {
      bin.position = move(bin.position);
    }
  }
  std::transform(world.places.begin(), world.places.end(), world.places.begin(), move);
  return world;
}

WallField wallsOf(const World& world, const WallFieldConfig& config = {},
                  const std::atomic<bool>& stop = kNever) {
  return estimateWalls(kHall, world.access_points, coveredBy(kHall, world.places, 0.1), kRadius,
                       config, stop);
}

/// Mean strength of a rectangle of the hall.
double strengthIn(const WallField& field, const Position& from, const Position& to) {
  double sum = 0.0, count = 0.0;
  forEachCell(kHall, [&](Cell c) {
    if (Box(from, to).contains(kHall.centre(c))) {
      sum += field.loss_db[c];
      count += 1.0;
    }
  });
  return sum / count;
}

bool isFinite(const WallField& field) {
  const auto finite = [](auto value) { return std::isfinite(value); };
  bool all = true;
  for (const LineField& member : field.members) {
    for (const LatticeLoss& loss : member) {
      for (const Grid<float>* grid : {&loss.walls_along_y, &loss.walls_along_x}) {
        all = all && std::all_of(grid->cells.begin(), grid->cells.end(), finite);
      }
    }
  }
  all = all && std::all_of(field.loss_db.cells.begin(), field.loss_db.cells.end(), finite);
  for (const std::vector<double>& losses : field.ray_loss_db) {
    all = all && std::all_of(losses.begin(), losses.end(), finite);
  }
  return all;
}

TEST(WallField, IsStrongWhereAWallIs) {
  const WallField field = wallsOf(twoRooms());
  const double wall = strengthIn(field, {-1.0, -2.0}, {0.0, 1.0});
  EXPECT_GT(wall, 3.0 * strengthIn(field, {-3.0, -1.0}, {-2.0, 0.5}));
  EXPECT_GT(wall, 10.0 * strengthIn(field, {1.5, -3.0}, {3.0, 3.0}));
}

TEST(WallField, IsTheMeanOfItsMembers) {
  // Shifts follow from a member's number, and no bin is left out: each is solved alone here.
  WallFieldConfig config;
  config.ensemble_size = 2;
  config.holdout_fraction = 0.0;
  const World world = twoRooms(2.0);
  const WallField field = wallsOf(world, config);
  const Mask path = coveredBy(kHall, world.places, 0.1);
  const Grid<double> distance = distanceTransform(path);
  std::vector<LineField> members;
  for (const Position& shift : {Position(0.0, 0.0), Position(0.1, 0.2 / 3.0)}) {
    const GridGeometry lattice(0.2, kHall.origin() - shift, 41, 41);
    Mask driven(lattice);
    for (std::size_t i = 0; i < driven.cells.size(); ++i) {
      const Cell c{static_cast<std::int64_t>(i) % 41, static_cast<std::int64_t>(i) / 41};
      const Cell at = kHall.cellAt(lattice.centre(c));
      driven[c] = kHall.contains(at) && distance[at] * kHall.resolution() <= kRadius ? 1 : 0;
    }
    members.push_back(
        solveLineField({{lattice}}, world.access_points, {driven}, config.line, kNever));
  }
  for (std::size_t i = 0; i < world.access_points[1].bins.size(); ++i) {
    const RadioBin& bin = world.access_points[1].bins[i];
    EXPECT_NEAR(field.ray_loss_db[1][i],
                0.5 * (lossBetween(members[0], world.access_points[1].position, bin.position) +
                       lossBetween(members[1], world.access_points[1].position, bin.position)),
                1e-9);
  }
  // Far from the path, which weakens walls beside it.
  for (const Position& place : {Position(-0.53, 0.12), Position(-0.31, -1.07), Position(0, 2)}) {
    double mean = 0.0;
    for (const LineField& one : members) {
      const LatticeLoss& loss = one.front();
      const Cell at = loss.lattice.geometry.cellAt(kHall.centre(kHall.cellAt(place)));
      mean += 0.5 * (loss.walls_along_y[at] + loss.walls_along_x[at]);
    }
    const double away = distance[kHall.cellAt(place)] * kHall.resolution() - kRadius;
    const double likely = std::pow(1.0 - std::exp(-away / 0.2), 2);
    EXPECT_NEAR(field.loss_db[kHall.cellAt(place)], likely * mean, 1e-4);
  }
}

/// Root mean square error of the losses across a slanted wall, on rays without readings, for a
/// number of wall directions [dB].
double errorOnASlant(int directions) {
  const LineLattice slant{kHall, kPi / 4.0};
  const StraightWall wall{true, 0.0, -2.0, 2.0, 7.0};
  World world;
  world.places = placesAlong({{-0.6, -2.8},
                              {-0.6, 2.8},
                              {-1.5, 2.8},
                              {-1.5, -2.8},
                              {-2.6, -2.8},
                              {-2.6, 2.8},
                              {0.6, 2.8},
                              {0.6, -2.8},
                              {1.7, -2.8},
                              {1.7, 2.8},
                              {2.6, 2.8},
                              {2.6, -2.8}});
  for (const Position& access_point :
       {Position(-2.1, 0.3), Position(-1.0, -1.9), Position(2.2, 1.1), Position(1.1, -2.0)}) {
    world.access_points.push_back(binsThrough({wall}, access_point, world.places, kAddUp, 1.0));
  }
  WallFieldConfig config;
  config.wall_directions = directions;
  config.line.max_total_wall_loss_db = kAddUp;
  config.line.covariance.nugget_db2 = 4.0;
  const WallField field =
      wallsOf(moved(world, [&](const Position& p) { return slant.toBuilding(p); }), config);
  Random random(1, 1, 0);
  double squares = 0.0;
  constexpr int kRays = 1000;
  for (int i = 0; i < kRays; ++i) {
    const double left = random.uniform(-2.8, 0.0), right = random.uniform(0.0, 2.8);
    const double low = random.uniform(-2.8, 2.8), high = random.uniform(-2.8, 2.8);
    const Position from(left, low), to(right, high);
    const double loss = lossBetween(field, slant.toBuilding(from), slant.toBuilding(to));
    squares += std::pow(loss - (test::crosses(wall, from, to) ? wall.loss_db : 0.0), 2);
  }
  return std::sqrt(squares / kRays);
}

TEST(WallField, HearsASlantedWallBetterInMoreDirections) {
  const double two = errorOnASlant(2);
  EXPECT_LT(errorOnASlant(4), 0.9 * two);
  EXPECT_LT(errorOnASlant(6), 0.9 * two);
}

TEST(WallField, TellsTheLossOfEachRay) {
  const World world = twoRooms();
  const WallField field = wallsOf(world);
  ASSERT_EQ(field.ray_loss_db.size(), 2U);
  const StraightWall wall{true, -0.5, -4.0, 1.5, 7.0};
  double behind = 0.0, aside = 0.0, behind_count = 0.0, aside_count = 0.0;
  for (std::size_t i = 0; i < world.places.size(); ++i) {
    const bool hidden = test::crosses(wall, world.access_points[0].position, world.places[i]);
    (hidden ? behind : aside) += field.ray_loss_db[0][i];
    (hidden ? behind_count : aside_count) += 1.0;
  }
  EXPECT_NEAR(behind / behind_count, 7.0, 2.0);
  EXPECT_LT(aside / aside_count, 0.5 * behind / behind_count);
}

/// Mean difference of strength from that of the moved world, as a share of the mean strength.
template <class Move>
double changeUnder(Move&& move) {
  const World world = twoRooms(1.0);
  const WallField field = wallsOf(world), other = wallsOf(moved(world, move));
  double difference = 0.0, sum = 0.0;
  forEachCell(kHall, [&](Cell c) {
    const Cell there = kHall.cellAt(move(kHall.centre(c)));
    difference += std::abs(field.loss_db[c] - other.loss_db[there]);
    sum += field.loss_db[c];
  });
  return difference / sum;
}

TEST(WallField, TurnsAndMirrorsWithTheWorld) {
  // The lattices' shifts do not turn, hence not exactly.
  EXPECT_LT(changeUnder([](const Position& p) { return Position(-p.x(), p.y()); }), 0.4);
  EXPECT_LT(changeUnder([](const Position& p) { return Position(p.x(), -p.y()); }), 0.4);
  EXPECT_LT(changeUnder([](const Position& p) { return Position(-p.y(), p.x()); }), 0.4);
}

TEST(WallField, IsWeakNextToTheRobot) {
  const World world = twoRooms(3.0);
  const WallField field = wallsOf(world);
  const Grid<double> distance = distanceTransform(coveredBy(kHall, world.places, 0.1));
  for (std::size_t i = 0; i < distance.cells.size(); ++i) {
    const Position centre = kHall.centre(kHall.cell(i));
    double both = 0.0;
    for (const LineField& member : field.members) {
      const LatticeLoss& loss = member.front();
      const Cell at = loss.lattice.geometry.cellAt(centre);
      both += (loss.walls_along_y[at] + loss.walls_along_x[at]) /
              static_cast<double>(field.members.size());
    }
    const double away = distance.cells[i] * kHall.resolution();
    EXPECT_LE(field.loss_db.cells[i], both + 1e-4);
    EXPECT_TRUE(away > kRadius || field.loss_db.cells[i] == 0.0F);
    EXPECT_TRUE(away < kRadius + 2.5 || field.loss_db.cells[i] >= 0.99 * both);
  }
}

TEST(WallField, IsTheSameEachTime) {
  const World world = twoRooms(2.0);
  const WallField first = wallsOf(world), again = wallsOf(world);
  EXPECT_EQ(first.loss_db.cells, again.loss_db.cells);
  EXPECT_EQ(first.ray_loss_db, again.ray_loss_db);
}

TEST(WallField, StopsWhenAsked) {
  const std::atomic<bool> stop{true};
  const WallField field = wallsOf(twoRooms(), {}, stop);
  EXPECT_EQ(strengthIn(field, {-4.0, -4.0}, {4.0, 4.0}), 0.0);
}

TEST(WallField, TakesDegenerateInput) {
  const Position inside(0.3, 0.2), outside(60.0, -45.0);
  const std::vector<World> worlds = {
      {{}, {}},
      {{AccessPointBins()}, {}},
      {{binsThrough({}, inside, {{2.0, 1.0}})}, {{2.0, 1.0}}},
      {{binsThrough({}, inside, {inside, inside})}, {inside}},
      {{binsThrough({}, outside, twoRooms().places)}, twoRooms().places},
      {{binsThrough({}, inside, {{90.0, 90.0}, {2.0, 1.0}})}, {}},
  };
  for (const World& world : worlds) {
    const WallField field = wallsOf(world);
    EXPECT_TRUE(isFinite(field));
    ASSERT_EQ(field.ray_loss_db.size(), world.access_points.size());
    for (std::size_t i = 0; i < world.access_points.size(); ++i) {
      EXPECT_EQ(field.ray_loss_db[i].size(), world.access_points[i].bins.size());
    }
  }
}

}  // namespace
}  // namespace sfw
