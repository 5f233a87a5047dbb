#include "structure_from_wifi/path_correction.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

#include "base/constants.h"
#include "path/odometry_checks.h"

namespace sfw {
namespace {

/// The largest drift of odometry per metre driven: that of poor wheels on carpet.
constexpr double kMostDrift = 0.1;  // [m/m]
constexpr double kMostTurn = 0.1;   // [rad/m]

/// Jumps closer together than this are one jump: tf interpolates between the transform before a
/// jump and the one after it, and a reading may fall in between.
constexpr std::int64_t kOneJump = 1000000000;  // [ns]

auto order(const OdometryCorrection& correction) {
  return std::make_tuple(std::cref(correction.robot), correction.stamp_ns, correction.is_between,
                         correction.antenna_in_map.x(), correction.antenna_in_map.y(),
                         correction.odom_in_map.x(), correction.odom_in_map.y(),
                         correction.odom_yaw_rad);
}

Position turned(double angle_rad, const Position& vector) {
  return Eigen::Rotation2Dd(angle_rad) * vector;
}

Position antennaInOdom(const OdometryCorrection& correction) {
  return turned(-correction.odom_yaw_rad, correction.antenna_in_map - correction.odom_in_map);
}

/// Returns where the antenna would be without the change from `before` to `correction`.
Position withoutJump(const OdometryCorrection& before, const OdometryCorrection& correction) {
  return before.odom_in_map + turned(before.odom_yaw_rad, antennaInOdom(correction));
}

double turnBetween(const OdometryCorrection& before, const OdometryCorrection& after) {
  return std::remainder(after.odom_yaw_rad - before.odom_yaw_rad, 2.0 * kPi);
}

/// A path over which jumps are spread, one after the other.
class SpreadPath {
 public:
  explicit SpreadPath(const std::vector<OdometryCorrection>& corrections)
      : corrections_(corrections), way_(corrections.size(), 0.0), turn_(corrections.size(), 0.0) {
    position_.reserve(corrections.size());
    for (std::size_t i = 0; i < corrections.size(); ++i) {
      position_.push_back(corrections[i].antenna_in_map);
      if (i > 0) {
        way_[i] = way_[i - 1] +
                  (antennaInOdom(corrections[i]) - antennaInOdom(corrections[i - 1])).norm();
      }
    }
  }

  double wayAt(std::size_t i) const { return way_[i]; }
  const Position& positionAt(std::size_t i) const { return position_[i]; }
  double turnAt(std::size_t i) const { return turn_[i]; }

  /// Moves the positions before a jump, which lasts from correction `begin` to correction `end`, so
  /// that the path ends at the position of `end`.
  /// @param since_m  distance driven at which drift began
  void spread(std::size_t begin, std::size_t end, double since_m) {
    const OdometryCorrection& before = corrections_[begin - 1];
    for (std::size_t i = begin; i < end; ++i) {  // tf may be between the two transforms
      position_[i] = withoutJump(before, corrections_[i]);
      turn_[i] = -turnBetween(before, corrections_[i]);
    }
    const Position arrival = withoutJump(before, corrections_[end]);
    const Position target = corrections_[end].antenna_in_map;
    const double turn_rad = turnBetween(before, corrections_[end]);
    const double needed_m =
        std::max((target - arrival).norm() / kMostDrift, std::abs(turn_rad) / kMostTurn);
    const double from_m = std::min(since_m, way_[end] - needed_m);
    const std::size_t first = lastBy(from_m, end);
    const auto share = [&](std::size_t i) {
      const double length_m = way_[end] - from_m;  // 0 only if the jump is zero
      return length_m > 0.0 ? std::max(0.0, (way_[i] - from_m) / length_m) : 1.0;
    };
    const Position rigid = target + turned(turn_rad, position_[first] - arrival);
    turnSteps(first, end, arrival, share(first) * (rigid - position_[first]),
              [&](std::size_t i) { return share(i) * turn_rad; });
    // The rest of the way to the target is spread over the chain of turned steps.
    const Position left = target - position_[end];
    for (std::size_t i = first; i <= end && share(first) < 1.0; ++i) {
      position_[i] += (share(i) - share(first)) / (1.0 - share(first)) * left;
    }
    position_[end] = target;
    turn_[end] = 0.0;
  }

 private:
  /// Returns the last correction before `end` up to a distance driven, or the first of all.
  std::size_t lastBy(double way_m, std::size_t end) const {
    const auto until = way_.begin() + static_cast<std::ptrdiff_t>(end);
    const auto after = std::upper_bound(way_.begin(), until, way_m);
    return static_cast<std::size_t>(after == way_.begin() ? 0 : after - way_.begin() - 1);
  }

  /// Turns each step of the path from `first` to `arrival` by the mean of the turns at its ends.
  /// `arrival` becomes the position of `end`, and the position of `first` moves by `shift`.
  template <class Turn>
  void turnSteps(std::size_t first, std::size_t end, const Position& arrival, const Position& shift,
                 const Turn& turn) {
    position_[end] = arrival;
    Position old = position_[first];
    position_[first] += shift;
    turn_[first] += turn(first);
    for (std::size_t i = first + 1; i <= end; ++i) {
      const Position step = position_[i] - old;
      old = position_[i];
      position_[i] = position_[i - 1] + turned(0.5 * (turn(i - 1) + turn(i)), step);
      turn_[i] += turn(i);
    }
  }

  const std::vector<OdometryCorrection>& corrections_;
  std::vector<double> way_;  // driven by odometry [m]
  std::vector<Position> position_;
  std::vector<double> turn_;  // by which each heading was corrected [rad]
};

}  // namespace

Position PathCorrection::moved(std::int64_t stamp_ns, const Position& point_in_map,
                               const std::string& robot) const {
  const auto found = std::lower_bound(moves_.begin(), moves_.end(), std::tie(robot, stamp_ns),
                                      [](const Move& move, const auto& wanted) {
                                        return std::tie(move.robot, move.stamp_ns) < wanted;
                                      });
  if (found == moves_.end() || found->robot != robot || found->stamp_ns != stamp_ns) {
    return point_in_map;
  }
  return found->to + turned(found->turn_rad, point_in_map - found->from);
}

void PathCorrector::insert(const OdometryCorrection& correction) {
  const bool finite = correction.antenna_in_map.allFinite() && correction.odom_in_map.allFinite() &&
                      std::isfinite(correction.odom_yaw_rad);
  // The readings of a scan come one after the other and share their correction.
  const bool repeated = !corrections_.empty() && order(corrections_.back()) == order(correction);
  if (finite && !repeated) {
    corrections_.push_back(correction);
  }
}

bool PathCorrector::isJump(const OdometryCorrection& before, const OdometryCorrection& after,
                           const Tolerance& tolerance) {
  const double distance_m = (after.antenna_in_map - withoutJump(before, after)).norm();
  return distance_m > tolerance.distance_m ||
         std::abs(turnBetween(before, after)) > tolerance.turn_rad;
}

std::size_t PathCorrector::endOfJump(const std::vector<OdometryCorrection>& readings,
                                     std::size_t begin) const {
  std::size_t end = begin;
  for (std::size_t i = begin + 1;
       i < readings.size() && readings[i].stamp_ns - readings[end].stamp_ns <= kOneJump; ++i) {
    end = isJump(readings[i - 1], readings[i], tolerance_) ? i : end;
  }
  return end;
}

PathCorrection PathCorrector::correction() const {
  std::vector<OdometryCorrection> corrections = corrections_;
  std::sort(
      corrections.begin(), corrections.end(),
      [](const OdometryCorrection& a, const OdometryCorrection& b) { return order(a) < order(b); });
  corrections.erase(std::unique(corrections.begin(), corrections.end(),
                                [](const OdometryCorrection& a, const OdometryCorrection& b) {
                                  return a.robot == b.robot && a.stamp_ns == b.stamp_ns;
                                }),
                    corrections.end());
  PathCorrection result;
  for (auto begin = corrections.cbegin(); begin != corrections.cend();) {
    const auto end = std::find_if(begin, corrections.cend(), [&](const OdometryCorrection& one) {
      return one.robot != begin->robot;
    });
    addMoves({begin, end}, result);
    begin = end;
  }
  return result;
}

void PathCorrector::addMoves(const std::vector<OdometryCorrection>& corrections,
                             PathCorrection& result) const {
  if (!areOfOdometry(corrections, tolerance_)) {
    return;
  }
  SpreadPath path(corrections);
  std::vector<OdometryCorrection> readings;
  std::vector<std::size_t> index;  // of each in the corrections
  for (std::size_t i = 0; i < corrections.size(); ++i) {
    if (!corrections[i].is_between) {
      readings.push_back(corrections[i]);
      index.push_back(i);
    }
  }
  double since_m = 0.0;  // distance driven at which the drift before the next jump begins
  for (std::size_t i = 1; i < readings.size(); ++i) {
    if (!isJump(readings[i - 1], readings[i], tolerance_)) {
      continue;
    }
    const std::size_t end = endOfJump(readings, i);
    path.spread(index[i - 1] + 1, index[end], since_m);
    since_m = path.wayAt(index[end]);
    i = end;
  }
  for (std::size_t i = 0; i < corrections.size(); ++i) {
    const Position& from = corrections[i].antenna_in_map;
    if (path.positionAt(i) != from || path.turnAt(i) != 0.0) {
      result.moves_.push_back({corrections[i].robot, corrections[i].stamp_ns, from,
                               path.positionAt(i), path.turnAt(i)});
    }
  }
}

}  // namespace sfw
