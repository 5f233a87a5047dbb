#include "simulation/building/plan_generator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>

#include "grid/distance_transform.h"
#include "grid/morphology.h"
#include "structure_from_wifi/input_error.h"
#include "support/ascii_world.h"

namespace sfw {
namespace {

PlanGeneratorConfig configOf(BuildingKind kind, double area, std::uint64_t seed) {
  PlanGeneratorConfig config;
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

/// The part in the middle of a room, or 0 if no robot fits there.
std::int64_t partIn(const Components& places, const GeneratedRoom& room, double rotation_rad) {
  const Eigen::Rotation2Dd turn(rotation_rad);
  constexpr double kStep = 0.05;
  for (double x = -0.25; x <= 0.25; x += kStep) {
    for (double y = -0.25; y <= 0.25; y += kStep) {
      const Position at = room.centre + turn * Position(x * room.size.x(), y * room.size.y());
      const std::int64_t part = places.label[places.label.geometry.cellAt(at)];
      if (part != 0) {
        return part;
      }
    }
  }
  return 0;
}

/// Areas and kinds of buildings, other ones for each seed.
PlanGeneratorConfig anyConfig(std::uint64_t seed) {
  const auto kind = seed % 2 == 0 ? BuildingKind::kFlat : BuildingKind::kOffice;
  PlanGeneratorConfig config = configOf(kind, 30.0 + static_cast<double>(seed * 37 % 371), seed);
  config.rotation_rad = seed % 3 == 0 ? 0.05 * static_cast<double>(seed % 60) : 0.0;
  return config;
}

constexpr std::uint64_t kSeeds = 200;

TEST(PlanGenerator, ARobotGetsIntoEveryRoom) {
  constexpr double kRadius = 0.25;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const PlanGeneratorConfig config = anyConfig(seed);
    const GeneratedPlan generated = generatePlan(config);
    const Components places = placesOf(generated.plan, kRadius);
    const std::int64_t first = partIn(places, generated.rooms.front(), config.rotation_rad);
    EXPECT_NE(first, 0) << "seed " << seed;
    for (const GeneratedRoom& room : generated.rooms) {
      EXPECT_EQ(partIn(places, room, config.rotation_rad), first)
          << "seed " << seed << ": " << toText(room.kind) << " at " << room.centre.transpose();
    }
  }
}

TEST(PlanGenerator, RoomsHaveSensibleSizes) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const GeneratedPlan generated = generatePlan(anyConfig(seed));
    for (const GeneratedRoom& room : generated.rooms) {
      const double narrow = room.size.minCoeff();
      const double area = room.size.prod();
      const std::string what = "seed " + std::to_string(seed) + ": " + toText(room.kind) + " of " +
                               std::to_string(room.size.x()) + " x " +
                               std::to_string(room.size.y());
      EXPECT_GE(narrow, 0.85) << what;
      EXPECT_GE(area, 1.2) << what;
      const bool to_live_in = room.kind == RoomKind::kBedroom || room.kind == RoomKind::kLiving ||
                              room.kind == RoomKind::kOffice || room.kind == RoomKind::kMeeting;
      if (to_live_in) {
        EXPECT_GE(narrow, 2.1) << what;
        EXPECT_GE(area, 6.0) << what;
      }
    }
  }
}

TEST(PlanGenerator, HasTheAreaAskedFor) {
  for (std::uint64_t seed = 0; seed < kSeeds; seed += 3) {
    PlanGeneratorConfig config = anyConfig(seed);
    const FloorPlan plan = generatePlan(config).plan;
    const double area =
        areaOf(cellsOf(plan, Material::kFree)) + areaOf(cellsOf(plan, Material::kInteriorWall));
    EXPECT_NEAR(area, config.area_m2, 0.02 * config.area_m2) << "seed " << seed;
  }
}

TEST(PlanGenerator, OuterWallsAreClosedAndThickerThanTheOthers) {
  for (std::uint64_t seed = 0; seed < kSeeds; seed += 5) {
    const FloorPlan plan = generatePlan(anyConfig(seed)).plan;
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

TEST(PlanGenerator, OneSeedGivesOneBuilding) {
  const PlanGeneratorConfig config = configOf(BuildingKind::kFlat, 100.0, 7);
  EXPECT_EQ(generatePlan(config).plan.cells, generatePlan(config).plan.cells);
}

TEST(PlanGenerator, SeedsGiveManyBuildings) {
  std::set<std::vector<Material>> buildings;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    buildings.insert(generatePlan(configOf(BuildingKind::kFlat, 80.0, seed)).plan.cells);
    buildings.insert(generatePlan(configOf(BuildingKind::kOffice, 80.0, seed)).plan.cells);
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

TEST(PlanGenerator, BuildingsStayTheSameOverTime) {
  EXPECT_EQ(hashOf(generatePlan(configOf(BuildingKind::kFlat, 70.0, 1)).plan),
            8153798947763950029u);
  EXPECT_EQ(hashOf(generatePlan(configOf(BuildingKind::kFlat, 250.0, 2)).plan),
            11276945947619835525u);
  EXPECT_EQ(hashOf(generatePlan(configOf(BuildingKind::kOffice, 300.0, 3)).plan),
            12072429945185949106u);
}

TEST(PlanGenerator, AStudioHasWhatAStudioHas) {
  std::string text;
  for (const GeneratedRoom& room : generatePlan(configOf(BuildingKind::kFlat, 32.0, 5)).rooms) {
    char line[64];
    std::snprintf(line, sizeof line, "%s %.2f x %.2f\n", toText(room.kind).c_str(), room.size.x(),
                  room.size.y());
    text += line;
  }
  EXPECT_EQ(text,
            "corridor 1.20 x 3.02\n"
            "living room 4.83 x 3.44\n"
            "kitchen 1.50 x 3.02\n"
            "bathroom 1.81 x 3.02\n");
}

TEST(PlanGenerator, TurnsTheWholeBuilding) {
  PlanGeneratorConfig config = configOf(BuildingKind::kFlat, 90.0, 4);
  const GeneratedPlan straight = generatePlan(config);
  config.rotation_rad = 0.5;
  const GeneratedPlan turned = generatePlan(config);
  const Eigen::Rotation2Dd turn(0.5);
  ASSERT_EQ(turned.rooms.size(), straight.rooms.size());
  for (std::size_t i = 0; i < turned.rooms.size(); ++i) {
    EXPECT_LT((turned.rooms[i].centre - turn * straight.rooms[i].centre).norm(), 1e-9);
  }
  EXPECT_NEAR(areaOf(cellsOf(turned.plan, Material::kFree)),
              areaOf(cellsOf(straight.plan, Material::kFree)), 0.5);
}

TEST(PlanGenerator, ListsEveryBadSetting) {
  PlanGeneratorConfig config;
  config.area_m2 = 29.0;
  config.resolution_m = 0.2;
  config.rotation_rad = std::nan("");
  try {
    generatePlan(config);
    FAIL() << "nothing thrown";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "area must lie in 30..400 m2; it is 29\n"
                 "resolution must lie in 0.01..0.1 m; it is 0.2\n"
                 "rotation_rad must be finite; it is nan");
  }
}

TEST(PlanGenerator, TakesTheEndsOfEachRange) {
  for (const BuildingKind kind : {BuildingKind::kFlat, BuildingKind::kOffice}) {
    for (const double area : {30.0, 400.0}) {
      PlanGeneratorConfig config = configOf(kind, area, std::numeric_limits<std::uint64_t>::max());
      config.resolution_m = 0.1;
      EXPECT_GT(areaOf(cellsOf(generatePlan(config).plan, Material::kFree)), 0.7 * area);
    }
  }
}

}  // namespace
}  // namespace sfw
