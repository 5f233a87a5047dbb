#include "path/building_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/constants.h"
#include "base/random.h"

namespace sfw {
namespace {

using Path = std::vector<Position>;
using Source = BuildingFrame::Source;

constexpr double kDegree = kPi / 180.0;
constexpr double kGap = 1.0;

/// Positions 0.1 m apart along the way points.
Path driven(const Path& way_points) {
  Path path;
  for (std::size_t i = 1; i < way_points.size(); ++i) {
    const Position along = way_points[i] - way_points[i - 1];
    const int steps = static_cast<int>(std::ceil(along.norm() / 0.1));
    for (int step = 0; step < steps; ++step) {
      path.push_back(way_points[i - 1] + along * step / steps);
    }
  }
  path.push_back(way_points.back());
  return path;
}

Path roundTheRooms() {
  return driven({{0, 0}, {8, 0}, {8, 5}, {4, 5}, {4, 1}, {1, 1}, {1, 5}, {0, 5}, {0, 0}});
}

Path moved(Path path, double yaw_rad, bool mirror = false) {
  for (Position& position : path) {
    position =
        Eigen::Rotation2Dd(yaw_rad) * Position(position.x(), mirror ? -position.y() : position.y());
  }
  return path;
}

Path jittered(Path path, double deviation) {
  Random random(1, 1, 0);
  for (Position& position : path) {
    position.x() += deviation * random.normal();
    position.y() += deviation * random.normal();
  }
  return path;
}

/// Between two directions, quarter turns aside [rad].
double angleBetween(double a, double b) { return std::abs(std::remainder(a - b, 0.5 * kPi)); }

double yawOf(const Path& path) { return findBuildingFrame(path, kGap).yaw_rad; }

TEST(BuildingFrame, FindsTheAngleOfARectangularPath) {
  for (int degrees = -180; degrees <= 180; degrees += 3) {
    const BuildingFrame frame = findBuildingFrame(moved(roundTheRooms(), degrees * kDegree), kGap);
    EXPECT_EQ(frame.source, Source::kHeadings);
    EXPECT_LT(angleBetween(frame.yaw_rad, degrees * kDegree), 0.3 * kDegree) << degrees;
    EXPECT_GE(frame.yaw_rad, -0.25 * kPi);
    EXPECT_LT(frame.yaw_rad, 0.25 * kPi);
  }
}

TEST(BuildingFrame, WithstandsJitter) {
  for (int degrees = -40; degrees <= 40; degrees += 10) {
    const Path path = jittered(moved(roundTheRooms(), degrees * kDegree), 0.01);
    EXPECT_LT(angleBetween(yawOf(path), degrees * kDegree), kDegree);
  }
}

TEST(BuildingFrame, FindsTheAngleOfAPatrolThatCutsCorners) {
  Random random(2, 1, 0);
  Path way_points{{0, 0}};
  for (int leg = 0; leg < 40; ++leg) {
    const double length = random.uniform(2.0, 6.0) * (leg % 4 < 2 ? 1.0 : -1.0);
    const double aside = random.uniform(-0.25, 0.25);
    way_points.push_back(way_points.back() +
                         (leg % 2 == 0 ? Position(length, aside) : Position(aside, length)));
  }
  const BuildingFrame frame = findBuildingFrame(moved(driven(way_points), 0.4), kGap);
  EXPECT_EQ(frame.source, Source::kHeadings);
  EXPECT_LT(angleBetween(frame.yaw_rad, 0.4), 1.0 * kDegree);
}

TEST(BuildingFrame, RefinementDisregardsASlantedLeg) {
  const Path path = driven({{0, 0}, {10, 0}, {10, 6}, {13, 8}, {13, 12}, {5, 12}});
  EXPECT_LT(angleBetween(yawOf(moved(path, 0.2)), 0.2), 0.3 * kDegree);
}

/// Circles: headings in all directions alike.
Path scattered(double width, double height) {
  Path path;
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 8; ++column) {
      const Position centre(width * (column + 0.5) / 8.0, height * (row + 0.5) / 8.0);
      for (int i = 0; i <= 16; ++i) {
        const double angle = 2.0 * kPi * i / 16.0;
        path.push_back(centre + 2.0 * Position(std::cos(angle), std::sin(angle)));
      }
    }
  }
  return path;
}

TEST(BuildingFrame, TakesTheLongAxisWhereHeadingsScatter) {
  for (int degrees = -40; degrees <= 40; degrees += 10) {
    const BuildingFrame frame =
        findBuildingFrame(moved(scattered(20.0, 2.0), degrees * kDegree), kGap);
    EXPECT_EQ(frame.source, Source::kSpread);
    EXPECT_LT(angleBetween(frame.yaw_rad, degrees * kDegree), 0.1 * kDegree) << degrees;
  }
}

TEST(BuildingFrame, KeepsTheMapsAxesWhereNothingShows) {
  for (const Path& path : {scattered(10.0, 10.0), Path{}, Path{{3, 4}}, Path(50, Position(3, 4))}) {
    const BuildingFrame frame = findBuildingFrame(path, kGap);
    EXPECT_EQ(frame.source, Source::kNone);
    EXPECT_EQ(frame.yaw_rad, 0.0);
  }
}

TEST(BuildingFrame, JumpsAreNoHeadings) {
  Path path;
  for (int stay = 0; stay < 20; ++stay) {
    const Position place(7.0 * (stay % 5), 7.3 * std::floor(stay / 5.0) + 2.0 * (stay % 5));
    path.insert(path.end(), {place, place + Position(0.5, 0.0)});
  }
  EXPECT_LT(angleBetween(yawOf(path), 0.0), 1e-9);
  EXPECT_GT(angleBetween(findBuildingFrame(path, 100.0).yaw_rad, 0.0), kDegree);
}

TEST(BuildingFrame, TurnsAndMirrorsWithThePath) {
  const Path path = jittered(roundTheRooms(), 0.02);
  const double yaw = yawOf(path);
  for (const double turn : {0.1, 0.5, 0.78, 0.79, 2.0, -3.0}) {
    EXPECT_NEAR(angleBetween(yawOf(moved(path, turn)), yaw + turn), 0.0, 1e-9);
  }
  EXPECT_NEAR(angleBetween(yawOf(moved(path, 0.0, true)), -yaw), 0.0, 1e-9);
  Path backwards = path;
  std::reverse(backwards.begin(), backwards.end());
  EXPECT_LT(angleBetween(yawOf(backwards), yaw), 0.3 * kDegree);
}

TEST(BuildingFrame, ChangesCoordinatesThereAndBack) {
  const BuildingFrame frame{0.3, Source::kHeadings};
  const Position along_x = frame.toMap({2.0, 0.0});
  EXPECT_NEAR(std::atan2(along_x.y(), along_x.x()), 0.3, 1e-12);
  EXPECT_LT((frame.toBuilding(frame.toMap({3.0, -4.0})) - Position(3.0, -4.0)).norm(), 1e-12);
}

}  // namespace
}  // namespace sfw
