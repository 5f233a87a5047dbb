#include "tomography/kept_members.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sfw {
namespace {

/// A kept member is moved with the building frame but not turned. So its corners are off by this at
/// most: a quarter of its cells.
constexpr double kFarthestOffM = 0.05;

/// Data have changed too much if they have so many more readings, or if an access point moved so
/// far. Checks of access points are repeated by the same rule (DataChecker).
constexpr double kMuchMore = 0.1;
constexpr double kMovedM = 0.1;

/// While the robot drives, a member waits until there are so many more readings or bins.
constexpr double kLittleMore = 0.01;

bool isSame(const RadioBin& a, const RadioBin& b) {
  return a.position == b.position && a.rssi_dbm == b.rssi_dbm && a.readings == b.readings;
}

bool isSame(const AccessPointBins& a, const AccessPointBins& b) {
  return a.position == b.position && a.height_m == b.height_m && a.noise_db2 == b.noise_db2 &&
         a.covariance == b.covariance &&
         std::equal(a.bins.begin(), a.bins.end(), b.bins.begin(), b.bins.end(),
                    [](const RadioBin& one, const RadioBin& other) { return isSame(one, other); });
}

bool isSame(const WallData& a, const WallData& b) {
  return a.yaw_rad == b.yaw_rad && a.path.geometry == b.path.geometry &&
         a.path.cells == b.path.cells &&
         std::equal(a.access_points.begin(), a.access_points.end(), b.access_points.begin(),
                    b.access_points.end(),
                    [](const AccessPointBins& one, const AccessPointBins& other) {
                      return isSame(one, other);
                    });
}

/// How far the corners of the grid move when the building frame turns about its centre [m].
double cornersMoveBy(double turn_rad, const WallData& data) {
  return 0.5 * std::abs(turn_rad) * data.path.geometry.box().diagonal().norm();
}

double countReadings(const WallData& data) {
  double readings = 0.0;
  for (const AccessPointBins& one : data.access_points) {
    for (const RadioBin& bin : one.bins) {
      readings += bin.readings;
    }
  }
  return readings;
}

double countBins(const WallData& data) {
  double bins = 0.0;
  for (const AccessPointBins& one : data.access_points) {
    bins += static_cast<double>(one.bins.size());
  }
  return bins;
}

std::vector<Position> accessPointsInMap(const WallData& data) {
  std::vector<Position> positions;
  for (const AccessPointBins& one : data.access_points) {
    positions.emplace_back(Eigen::Rotation2Dd(data.yaw_rad) * one.position);
  }
  return positions;
}

/// The same walls in a building frame that is turned a little: each lattice goes where its centre
/// is, and keeps its directions in the building.
LineField movedBy(double turn_rad, const LineField& walls) {
  LineField moved;
  for (const LatticeLoss& loss : walls) {
    const LineLattice& lattice = loss.lattice;
    const GridGeometry& geometry = lattice.geometry;
    const Position centre = geometry.box().center();
    const Position now =
        lattice.toLattice(Eigen::Rotation2Dd(turn_rad) * lattice.toBuilding(centre));
    LatticeLoss& one = moved.emplace_back(loss);
    one.lattice.geometry = GridGeometry(geometry.resolution(), geometry.origin() + now - centre,
                                        geometry.width(), geometry.height());
    one.walls_along_y.geometry = one.lattice.geometry;
    one.walls_along_x.geometry = one.lattice.geometry;
  }
  return moved;
}

}  // namespace

std::vector<LineField> KeptMembers::refresh(const WallData& now, int members, const Solve& solve,
                                            const std::atomic<bool>& stop) {
  const bool is_new = !last_ || !isSame(*last_, now);
  if (is_new) {
    std::optional<WallData> data(now);  // if memory runs out, nothing changes
    last_.swap(data);
    ++version_;
  }
  members_.resize(static_cast<std::size_t>(members));
  const auto oldest =
      std::min_element(members_.begin(), members_.end(),
                       [](const Member& a, const Member& b) { return a.version < b.version; });
  for (Member& member : members_) {
    const bool is_due = &member == &*oldest && member.version != version_ &&
                        (!is_new || hasGrownSince(member, now));
    if (!stop && (is_due || isTooOld(member, now))) {
      LineField walls = solve(static_cast<int>(&member - members_.data()));
      if (!stop) {
        member = {std::move(walls),   version_,       now.yaw_rad,
                  countReadings(now), countBins(now), accessPointsInMap(now)};
      }
    }
  }
  std::vector<LineField> all;
  for (const Member& member : members_) {
    all.push_back(member.yaw_rad == now.yaw_rad
                      ? member.walls
                      : movedBy(member.yaw_rad - now.yaw_rad, member.walls));
  }
  return all;
}

bool KeptMembers::isUnfinished() const {
  return std::any_of(members_.begin(), members_.end(),
                     [&](const Member& member) { return member.version != version_; });
}

bool KeptMembers::hasGrownSince(const Member& member, const WallData& now) {
  return countReadings(now) >= (1.0 + kLittleMore) * member.readings ||
         countBins(now) >= (1.0 + kLittleMore) * member.bins;
}

bool KeptMembers::isTooOld(const Member& member, const WallData& now) {
  const double readings = countReadings(now);
  if (member.version == 0 || cornersMoveBy(member.yaw_rad - now.yaw_rad, now) > kFarthestOffM ||
      readings < member.readings || readings > (1.0 + kMuchMore) * member.readings) {
    return true;
  }
  const std::vector<Position> access_points = accessPointsInMap(now);
  return std::any_of(member.access_points_in_map.begin(), member.access_points_in_map.end(),
                     [&](const Position& before) {
                       return std::none_of(access_points.begin(), access_points.end(),
                                           [&](const Position& position) {
                                             return (position - before).norm() <= kMovedM;
                                           });
                     });
}

}  // namespace sfw
