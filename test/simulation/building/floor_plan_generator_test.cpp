#include "simulation/building/floor_plan_generator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "grid/distance_transform.h"
#include "grid/morphology.h"
#include "structure_from_wifi/input_error.h"
#include "support/ascii_world.h"

namespace sfw {
namespace {

BuildingConfig configOf(BuildingKind kind, double area, std::uint64_t seed) {
  BuildingConfig config;
  config.kind = kind;
  config.area_m2 = area;
  config.seed = seed;
  return config;
}

Mask cellsOf(const FloorPlan& plan, Material material) {
  Mask mask(plan.geometry);
  for (std::size_t i = 0; i < mask.cells.size(); ++i) {
    mask.cells[i] = plan.cells[i] == material ? 1 : 0;
  }
  return mask;
}

/// [m2]
double areaOf(const Mask& mask) {
  const double edge = mask.geometry.resolution();
  return edge * edge * static_cast<double>(std::count(mask.cells.begin(), mask.cells.end(), 1));
}

/// Where the centre of a robot may be, each connected part with its own number.
Components placesOf(const FloorPlan& plan, double robot_radius) {
  const Mask walls = complement(cellsOf(plan, Material::kFree));
  return labelComponents(
      complement(dilated(walls, robot_radius / plan.geometry.resolution() + std::sqrt(0.5))));
}

/// Areas and kinds of buildings, other ones for each seed.
BuildingConfig anyConfig(std::uint64_t seed) {
  const auto kind = seed % 2 == 0 ? BuildingKind::kFlat : BuildingKind::kOffice;
  BuildingConfig config = configOf(kind, 30.0 + static_cast<double>(seed * 37 % 371), seed);
  config.rotation_rad = seed % 3 == 0 ? 0.05 * static_cast<double>(seed % 60) : 0.0;
  return config;
}

constexpr std::uint64_t kSeeds = 200;

/// The greatest distance [m] of a free cell from the places that a robot reaches from one of them.
double farthestFromRobot(const FloorPlan& plan, double robot_radius) {
  const Components places = placesOf(plan, robot_radius);
  Mask reached(plan.geometry);
  for (std::size_t i = 0; i < reached.cells.size(); ++i) {
    reached.cells[i] = places.label.cells[i] == 1 ? 1 : 0;
  }
  const Grid<double> distance = distanceTransform(reached);
  double farthest = 0.0;
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    if (plan.cells[i] == Material::kFree) {
      farthest = std::max(farthest, distance.cells[i]);
    }
  }
  return farthest * plan.geometry.resolution();
}

TEST(FloorPlanGenerator, ARobotGetsIntoEveryRoom) {
  // The robot gets within 0.25 m of walls, so within 0.36 m of corners. The middle of a room that
  // it cannot enter is 0.42 m from walls of 0.1 m, and the robot stays 0.25 m away from them.
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    EXPECT_LT(farthestFromRobot(generateFloorPlan(anyConfig(seed)), 0.25), 0.6) << "seed " << seed;
  }
}

TEST(FloorPlanGenerator, HasTheAreaAskedFor) {
  for (std::uint64_t seed = 0; seed < kSeeds; seed += 3) {
    BuildingConfig config = anyConfig(seed);
    const FloorPlan plan = generateFloorPlan(config);
    const double area =
        areaOf(cellsOf(plan, Material::kFree)) + areaOf(cellsOf(plan, Material::kInteriorWall));
    EXPECT_NEAR(area, config.area_m2, 0.02 * config.area_m2) << "seed " << seed;
  }
}

TEST(FloorPlanGenerator, OuterWallsAreClosedAndThickerThanTheOthers) {
  for (std::uint64_t seed = 0; seed < kSeeds; seed += 5) {
    const FloorPlan plan = generateFloorPlan(anyConfig(seed));
    const Mask outside = cellsOf(plan, Material::kUnknown);
    const Mask outer = cellsOf(plan, Material::kOuterWall);
    EXPECT_EQ(labelComponents(outside).count, 1);
    const Grid<double> to_outside = distanceTransform(outside);
    double thinnest = std::numeric_limits<double>::infinity();
    double thickest = 0.0;
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
      if (plan.cells[i] == Material::kFree) {
        thinnest = std::min(thinnest, to_outside.cells[i]);
      } else if (plan.cells[i] == Material::kOuterWall) {
        thickest = std::max(thickest, to_outside.cells[i]);
      }
    }
    EXPECT_GE(thinnest * plan.geometry.resolution(), 0.20) << "seed " << seed;
    EXPECT_LE(thickest * plan.geometry.resolution(), 0.40 * std::sqrt(2.0)) << "seed " << seed;
  }
}

TEST(FloorPlanGenerator, OneSeedGivesOneBuilding) {
  const BuildingConfig config = configOf(BuildingKind::kFlat, 100.0, 7);
  EXPECT_EQ(generateFloorPlan(config).cells, generateFloorPlan(config).cells);
}

TEST(FloorPlanGenerator, SeedsGiveManyBuildings) {
  std::set<std::vector<Material>> buildings;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    buildings.insert(generateFloorPlan(configOf(BuildingKind::kFlat, 80.0, seed)).cells);
    buildings.insert(generateFloorPlan(configOf(BuildingKind::kOffice, 80.0, seed)).cells);
  }
  EXPECT_EQ(buildings.size(), 100u);
}

/// A value that changes with any cell (FNV-1a).
std::uint64_t hashOf(const FloorPlan& plan) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const Material material : plan.cells) {
    hash = (hash ^ static_cast<std::uint64_t>(material)) * 0x100000001b3;
  }
  return hash;
}

TEST(FloorPlanGenerator, BuildingsStayTheSameOverTime) {
  EXPECT_EQ(hashOf(generateFloorPlan(configOf(BuildingKind::kFlat, 70.0, 1))),
            8153798947763950029u);
  EXPECT_EQ(hashOf(generateFloorPlan(configOf(BuildingKind::kFlat, 250.0, 2))),
            11276945947619835525u);
  EXPECT_EQ(hashOf(generateFloorPlan(configOf(BuildingKind::kOffice, 300.0, 3))),
            12072429945185949106u);
}

TEST(FloorPlanGenerator, TurnsTheWholeBuilding) {
  BuildingConfig config = configOf(BuildingKind::kFlat, 90.0, 4);
  const FloorPlan straight = generateFloorPlan(config);
  config.rotation_rad = 0.5;
  const FloorPlan turned = generateFloorPlan(config);
  const Eigen::Rotation2Dd turn(0.5);
  std::size_t built = 0, same = 0;
  Cell c;
  for (c.y = 0; c.y < straight.geometry.height(); ++c.y) {
    for (c.x = 0; c.x < straight.geometry.width(); ++c.x) {
      if (straight[c] != Material::kUnknown) {
        ++built;
        const Cell there = turned.geometry.cellAt(turn * straight.geometry.centre(c));
        same += turned[there] == straight[c] ? 1 : 0;
      }
    }
  }
  // Cells at the edges of walls may differ.
  EXPECT_GT(static_cast<double>(same), 0.9 * static_cast<double>(built));
  EXPECT_NEAR(areaOf(cellsOf(turned, Material::kFree)), areaOf(cellsOf(straight, Material::kFree)),
              0.5);
}

TEST(FloorPlanGenerator, ListsEveryBadSetting) {
  BuildingConfig config;
  config.area_m2 = 29.0;
  config.resolution_m = 0.2;
  config.rotation_rad = std::nan("");
  try {
    generateFloorPlan(config);
    FAIL() << "nothing thrown";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "area must lie in 30..400 m2; it is 29\n"
                 "resolution must lie in 0.01..0.1 m; it is 0.2\n"
                 "rotation_rad must be finite; it is nan");
  }
}

TEST(FloorPlanGenerator, TakesTheEndsOfEachRange) {
  for (const BuildingKind kind : {BuildingKind::kFlat, BuildingKind::kOffice}) {
    for (const double area : {30.0, 400.0}) {
      BuildingConfig config = configOf(kind, area, std::numeric_limits<std::uint64_t>::max());
      config.resolution_m = 0.1;
      EXPECT_GT(areaOf(cellsOf(generateFloorPlan(config), Material::kFree)), 0.7 * area);
    }
  }
}

}  // namespace
}  // namespace sfw
