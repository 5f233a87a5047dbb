#include "tomography/kept_members.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.h"
#include "support/radio_walls.h"
#include "tomography/wall_field.h"

namespace sfw {
namespace {

using test::binsThrough;
using test::coveredBy;
using test::placesAlong;

const std::atomic<bool> kNever{false};
const GridGeometry kHall(0.1, {-4.0, -4.0}, 80, 80);
constexpr double kRadius = 0.2;

/// The data after a share of a drive through two rooms with a wall between them.
WallData dataAfter(double share) {
  const std::vector<Position> places =
      placesAlong({{-1.7, -3.1}, {-1.7, 3.1}, {0.5, 3.1}, {0.5, -3.1}, {1.7, -3.1}, {1.7, 3.1}});
  const std::vector<Position> part(
      places.begin(), places.begin() + std::lround(share * static_cast<double>(places.size())));
  WallData data{0.0, {}, coveredBy(kHall, part, 0.1)};
  for (const Position& access_point : {Position(-3.1, 0.3), Position(-2.7, -2.9)}) {
    data.access_points.push_back(binsThrough({{true, -0.5, -4.0, 1.5, 7.0}}, access_point, part));
  }
  return data;
}

WallField anew(const WallData& data, const WallFieldConfig& config = {}) {
  return estimateWalls(kHall, data.access_points, data.path, kRadius, config, kNever);
}

WallField refreshed(const WallData& data, KeptMembers& kept, const WallFieldConfig& config = {}) {
  return refreshWalls(data, kRadius, config, kNever, kept);
}

bool isSame(const LineField& a, const LineField& b) {
  bool same = a.size() == b.size();
  for (std::size_t i = 0; same && i < a.size(); ++i) {
    same = a[i].lattice.geometry == b[i].lattice.geometry &&
           a[i].walls_along_x.cells == b[i].walls_along_x.cells &&
           a[i].walls_along_y.cells == b[i].walls_along_y.cells;
  }
  return same;
}

int countOthers(const WallField& a, const WallField& b) {
  int others = 0;
  for (std::size_t i = 0; i < a.members.size(); ++i) {
    others += isSame(a.members[i], b.members[i]) ? 0 : 1;
  }
  return others;
}

void expectSame(const WallField& a, const WallField& b) {
  EXPECT_EQ(countOthers(a, b), 0);
  EXPECT_EQ(a.loss_db.cells, b.loss_db.cells);
  EXPECT_EQ(a.ray_loss_db, b.ray_loss_db);
}

TEST(KeptMembers, TheFirstRefreshSolvesAll) {
  const WallData data = dataAfter(0.9);
  KeptMembers kept;
  expectSame(refreshed(data, kept), anew(data));
  EXPECT_FALSE(kept.isUnfinished());
}

TEST(KeptMembers, EachRefreshSolvesOneUntilAllAreOfNow) {
  const WallData now = dataAfter(0.95);
  const WallField all_anew = anew(now);
  KeptMembers kept;
  refreshed(dataAfter(0.9), kept);
  for (int left = 7; left >= 0; --left) {
    const WallField live = refreshed(now, kept);
    EXPECT_EQ(countOthers(live, all_anew), left);
    EXPECT_EQ(kept.isUnfinished(), left > 0);
  }
  expectSame(refreshed(now, kept), all_anew);
}

TEST(KeptMembers, SolvesTheOldestFirst) {
  KeptMembers kept;
  refreshed(dataAfter(0.90), kept);
  const WallData then = dataAfter(0.93);
  const WallData now = dataAfter(0.96);
  refreshed(then, kept);
  const WallField live = refreshed(now, kept);
  EXPECT_TRUE(isSame(live.members[0], anew(then).members[0]));
  EXPECT_TRUE(isSame(live.members[1], anew(now).members[1]));
}

TEST(KeptMembers, FewMoreDataWait) {
  KeptMembers kept;
  WallData data = dataAfter(0.9);
  const WallField before = refreshed(data, kept);
  for (int i = 0; i < 3; ++i) {
    data.access_points[0].bins[0].readings += 0.1;
    EXPECT_EQ(countOthers(refreshed(data, kept), before), 0);
    EXPECT_TRUE(kept.isUnfinished());
  }
  data.access_points[0].bins[0].readings += 5.0;
  EXPECT_EQ(countOthers(refreshed(data, kept), before), 1);
}

TEST(KeptMembers, MuchMoreDataSolveAllAtOnce) {
  KeptMembers kept;
  refreshed(dataAfter(0.5), kept);
  const WallData now = dataAfter(0.9);
  expectSame(refreshed(now, kept), anew(now));
}

TEST(KeptMembers, FewerDataSolveAllAtOnce) {
  KeptMembers kept;
  refreshed(dataAfter(0.9), kept);
  const WallData now = dataAfter(0.88);
  expectSame(refreshed(now, kept), anew(now));
}

TEST(KeptMembers, AMovedAccessPointSolvesAllAtOnce) {
  KeptMembers kept;
  WallData data = dataAfter(0.9);
  refreshed(data, kept);
  data.access_points[1].position.x() += 0.05;  // estimates jitter
  EXPECT_EQ(countOthers(refreshed(data, kept), anew(data)), 8);
  data.access_points[1].position.x() += 0.15;
  expectSame(refreshed(data, kept), anew(data));
}

TEST(KeptMembers, ALargeTurnOfTheBuildingSolvesAllAtOnce) {
  KeptMembers kept;
  WallData data = dataAfter(0.9);
  refreshed(data, kept);
  data.yaw_rad = 0.6 * kPi / 180.0;  // the corners are 5.7 m from the centre
  expectSame(refreshed(data, kept), anew(data));
}

TEST(KeptMembers, ASmallTurnMovesMembersWithTheBuilding) {
  // The building is far from the origin of its frame, as with coordinates of a country's grid: a
  // small turn moves it by metres.
  const Position far(4e4, -3e4);
  const double turn = 0.05 * kPi / 180.0;
  const auto shifted = [&](const Position& by) {
    WallData data = dataAfter(0.9);
    for (AccessPointBins& one : data.access_points) {
      one.position += by;
      for (RadioBin& bin : one.bins) {
        bin.position += by;
      }
    }
    data.path.geometry = GridGeometry(0.1, kHall.origin() + by, 80, 80);
    return data;
  };
  KeptMembers kept;
  refreshed(shifted(far), kept);
  WallData now = shifted(Eigen::Rotation2Dd(-turn) * far);
  now.yaw_rad = turn;
  const WallField live = refreshed(now, kept);
  const WallField all_anew =
      estimateWalls(now.path.geometry, now.access_points, now.path, kRadius, {}, kNever);
  double difference = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < live.loss_db.cells.size(); ++i) {
    difference += std::abs(live.loss_db.cells[i] - all_anew.loss_db.cells[i]);
    sum += all_anew.loss_db.cells[i];
  }
  EXPECT_LT(difference, 0.05 * sum);
}

TEST(KeptMembers, AGrownGridIsNoWallUntilMembersCoverIt) {
  KeptMembers kept;
  const WallData before = dataAfter(0.9);
  refreshed(before, kept);
  WallData now = before;
  now.path = Mask(GridGeometry(0.1, {-6.0, -6.0}, 120, 120));
  forEachCell(kHall, [&](Cell c) { now.path[{c.x + 20, c.y + 20}] = before.path[c]; });
  for (int i = 0; i < 8; ++i) {
    refreshed(now, kept);
  }
  const WallField all_anew =
      estimateWalls(now.path.geometry, now.access_points, now.path, kRadius, {}, kNever);
  expectSame(refreshed(now, kept), all_anew);
}

TEST(KeptMembers, AStopKeepsNothingNew) {
  KeptMembers kept;
  refreshed(dataAfter(0.9), kept);
  const WallData now = dataAfter(0.95);
  const std::atomic<bool> stop{true};
  refreshWalls(now, kRadius, {}, stop, kept);
  EXPECT_EQ(countOthers(refreshed(now, kept), anew(now)), 7);
}

}  // namespace
}  // namespace sfw
