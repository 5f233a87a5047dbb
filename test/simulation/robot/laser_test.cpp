#include "simulation/robot/laser.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/random.h"
#include "simulation/building/floor_plan.h"
#include "simulation/building/floor_plan_generator.h"
#include "support/robot_room.h"

namespace sfw {
namespace {

using test::room;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

LaserConfig laserWith(std::int64_t beams, double range_m) {
  LaserConfig config;
  config.beams = beams;
  config.range_m = range_m;
  return config;
}

TEST(Laser, MeasuresTheWallsOfARoom) {
  const auto ranges = laserRanges(room(), {{1.0, 0.75}, 0.0}, laserWith(8, 8.0));
  const double diagonal = std::sqrt(2.0);
  // Backwards, then counter-clockwise.
  const std::vector<double> expected{1.0, 0.75 * diagonal, 0.75, 0.75 * diagonal,
                                     3.0, 1.25 * diagonal, 1.25, diagonal};
  ASSERT_EQ(ranges.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(ranges[i], expected[i], 1e-9) << "beam " << i;
  }
}

TEST(Laser, TurnsWithTheRobot) {
  const auto ranges = laserRanges(room(), {{1.0, 0.75}, kPi / 2}, laserWith(4, 8.0));
  EXPECT_NEAR(ranges[2], 1.25, 1e-9) << "ahead";
  EXPECT_NEAR(ranges[3], 1.0, 1e-9) << "to the left";
}

TEST(Laser, SeesNothingBeyondItsRange) {
  const auto ranges = laserRanges(room(), {{1.0, 0.75}, 0.0}, laserWith(4, 1.1));
  EXPECT_EQ(ranges[2], kInfinity) << "ahead";
  EXPECT_NEAR(ranges[0], 1.0, 1e-9) << "behind";
}

TEST(Laser, SeesTheEndOfThePlan) {
  const Grid<CellState> open(GridGeometry(0.1, {0.0, 0.0}, 10, 10), CellState::kFree);
  EXPECT_NEAR(laserRanges(open, {{0.25, 0.5}, 0.0}, laserWith(4, 8.0))[2], 0.75, 1e-9);
}

TEST(Laser, EndsBeamsAtTheFirstCellThatIsNotFree) {
  BuildingConfig building;
  building.rotation_rad = 0.3;
  building.resolution_m = 0.1;
  const Grid<CellState> plan = toStates(generateFloorPlan(building));
  const auto isFree = [&](const Position& point) {
    const Cell c = plan.geometry.cellAt(point);
    return plan.geometry.contains(c) && plan[c] == CellState::kFree;
  };
  const LaserConfig laser = laserWith(60, 5.0);
  Random random(1, 1, 1);
  const Box box = plan.geometry.box();
  for (int places = 0; places < 20;) {
    const RobotPose pose{{random.uniform(box.min().x(), box.max().x()),
                          random.uniform(box.min().y(), box.max().y())},
                         random.uniform(-kPi, kPi)};
    if (!isFree(pose.position)) {
      continue;
    }
    ++places;
    const std::vector<double> ranges = laserRanges(plan, pose, laser);
    for (std::int64_t beam = 0; beam < laser.beams; ++beam) {
      const double range = ranges[static_cast<std::size_t>(beam)];
      const double bearing = pose.yaw_rad + beamBearing(laser, beam);
      const Position direction(std::cos(bearing), std::sin(bearing));
      constexpr double kStep = 0.001;
      const double last = std::min(range, laser.range_m) - 1e-6;
      for (double at = 0.0; at < last; at += kStep) {
        ASSERT_TRUE(isFree(pose.position + at * direction)) << beam << " at " << at;
      }
      if (range < kInfinity) {
        EXPECT_FALSE(isFree(pose.position + (range + 1e-6) * direction)) << beam;
      }
    }
  }
}

}  // namespace
}  // namespace sfw
