#include "simulation/robot/simulated_robot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "base/constants.h"
#include "base/validation.h"
#include "simulation/robot/box_entry.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

constexpr double kChordDuration = 0.01;  // [s]
constexpr double kBumperTravel = 1e-4;   // travel of a bumper before it makes contact [m]
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The robot stops at this distance from an obstacle, so that rounding does not keep it from
/// driving along a wall that it touches [m].
constexpr double kSkin = 1e-6;

constexpr double kRounding = 1e-12;  // smaller differences of distances are rounding [m]
constexpr double kOverlap = 1e-9;    // the sum of such differences [m]

/// A value moved towards a target by at most a step.
double approached(double value, double target, double most) {
  return value + std::clamp(target - value, -most, most);
}

/// The distance along a ray at which it enters a disc; infinity if it never does.
double entryIntoDisc(const Position& from, const Position& direction, const Position& centre,
                     double radius_m) {
  const Position to_centre = centre - from;
  const double along = to_centre.dot(direction);
  const double across = to_centre.x() * direction.y() - to_centre.y() * direction.x();
  const double half_chord_squared = radius_m * radius_m - across * across;
  if (along <= 0.0 || half_chord_squared <= 0.0) {
    return kInfinity;
  }
  return along - std::sqrt(half_chord_squared);
}

Position nearestPoint(const Box& box, const Position& point) {
  return point.cwiseMax(box.min()).cwiseMin(box.max());
}

/// The distance that a disc can move along a ray before it overlaps a rectangle. It must not
/// overlap the rectangle at the start.
double distanceToOverlap(const Position& from, const Position& direction, const Box& box,
                         double radius_m) {
  // The rectangle grown by the disc: two rectangles and four discs.
  double distance = kInfinity;
  for (int axis = 0; axis < 2; ++axis) {
    const Position grown = axis == 0 ? Position(radius_m, 0.0) : Position(0.0, radius_m);
    distance = std::min(distance,
                        entryIntoBox(from, direction, Box(box.min() - grown, box.max() + grown)));
  }
  for (int corner = 0; corner < 4; ++corner) {
    const Position at = box.corner(static_cast<Box::CornerType>(corner));
    distance = std::min(distance, entryIntoDisc(from, direction, at, radius_m));
  }
  return std::max(distance, 0.0);
}

}  // namespace

std::vector<std::string> validate(const SimulatedRobot::Config& config) {
  Problems problems;
  problems.within("radius", config.radius_m, 0.01, 10.0);
  problems.within("max_speed", config.max_speed_m_s, 0.01, 10.0);
  problems.within("max_yaw_rate", config.max_yaw_rate_rad_s, 0.01, 100.0);
  problems.within("acceleration", config.acceleration_m_s2, 0.01, 1000.0);
  problems.within("yaw_acceleration", config.yaw_acceleration_rad_s2, 0.01, 10000.0);
  problems.within("command_timeout", config.command_timeout_s, 0.0, 3600.0);
  return problems.list();
}

SimulatedRobot::SimulatedRobot(const Grid<CellState>& plan, const RobotPose& start,
                               const Config& config)
    : plan_(plan), config_(config), pose_(start) {
  throwIfAny(validate(config));
  std::string text;
  forEachObstacle(Box(start.position), config.radius_m, [&](const Box& square) {
    if (text.empty() && square.exteriorDistance(start.position) < config.radius_m) {
      char words[160];
      std::snprintf(
          words, sizeof words, "the robot does not fit at (%.2f, %.2f): (%.2f, %.2f) is not free",
          start.position.x(), start.position.y(), square.center().x(), square.center().y());
      text = words;
    }
  });
  if (!text.empty()) {
    throw InputError(text);
  }
}

bool SimulatedRobot::command(const DriveCommand& command) {
  if (!std::isfinite(command.speed_m_s) || !std::isfinite(command.yaw_rate_rad_s)) {
    return false;
  }
  command_.speed_m_s = std::clamp(command.speed_m_s, -config_.max_speed_m_s, config_.max_speed_m_s);
  command_.yaw_rate_rad_s =
      std::clamp(command.yaw_rate_rad_s, -config_.max_yaw_rate_rad_s, config_.max_yaw_rate_rad_s);
  command_age_s_ = 0.0;
  return true;
}

void SimulatedRobot::step(double duration_s) {
  const auto chords = static_cast<int>(std::ceil(duration_s / kChordDuration - 1e-9));
  for (int i = 0; i < chords; ++i) {
    driveChord(duration_s / chords);
  }
}

void SimulatedRobot::driveChord(double duration_s) {
  if (config_.command_timeout_s > 0.0 && command_age_s_ >= config_.command_timeout_s) {
    command_ = {};
  }
  command_age_s_ += duration_s;
  speed_m_s_ = approached(speed_m_s_, command_.speed_m_s, config_.acceleration_m_s2 * duration_s);
  yaw_rate_rad_s_ = approached(yaw_rate_rad_s_, command_.yaw_rate_rad_s,
                               config_.yaw_acceleration_rad_s2 * duration_s);
  const double half_turn = 0.5 * yaw_rate_rad_s_ * duration_s;
  const double arc = speed_m_s_ * duration_s;
  const double chord = half_turn == 0.0 ? arc : arc * std::sin(half_turn) / half_turn;
  if (chord != 0.0) {
    const double yaw = pose_.yaw_rad + half_turn;
    const Position direction = std::copysign(1.0, chord) * Position(std::cos(yaw), std::sin(yaw));
    const FreePath path = freePath(direction, std::abs(chord));
    pose_.position += path.length_m * direction;
    driven_m_ += path.length_m;
    speed_m_s_ = path.obstacle ? 0.0 : speed_m_s_;
  }
  pose_.yaw_rad = std::remainder(pose_.yaw_rad + 2.0 * half_turn, 2.0 * kPi);
}

std::optional<Position> SimulatedRobot::contact() const {
  return freePath({std::cos(pose_.yaw_rad), std::sin(pose_.yaw_rad)}, kBumperTravel).obstacle;
}

SimulatedRobot::FreePath SimulatedRobot::freePath(const Position& direction,
                                                  double length_m) const {
  const Position& from = pose_.position;
  const double stop_m = config_.radius_m + kSkin;
  double distance_m = stop_m;
  forEachObstacle(Box(from), stop_m, [&](const Box& square) {
    distance_m = std::min(distance_m, square.exteriorDistance(from));
  });
  // Within the skin the robot may continue, but not nearer to any obstacle than it is.
  const double radius_m = std::max(config_.radius_m - kOverlap, distance_m - kRounding);
  Box swept(from);
  swept.extend(Position(from + length_m * direction));
  FreePath path{length_m, std::nullopt};
  forEachObstacle(swept, stop_m, [&](const Box& square) {
    const double until = distanceToOverlap(from, direction, square, radius_m);
    if (until < path.length_m) {
      path.length_m = until;
      path.obstacle = nearestPoint(square, from + until * direction);
    }
  });
  // Otherwise a robot that presses against a wall would creep into it by repeated rounding.
  path.length_m = path.obstacle && path.length_m < kOverlap ? 0.0 : path.length_m;
  return path;
}

template <class Visitor>
void SimulatedRobot::forEachObstacle(const Box& around, double distance_m, Visitor&& visit) const {
  const GridGeometry& geometry = plan_.geometry;
  // One more cell on each side, because a point on an edge belongs to one cell but touches two.
  const Cell first = geometry.cellAt(around.min() - Position::Constant(distance_m));
  const Cell last = geometry.cellAt(around.max() + Position::Constant(distance_m));
  const Position half_cell = Position::Constant(0.5 * geometry.resolution());
  Cell c;
  for (c.y = first.y - 1; c.y <= last.y + 1; ++c.y) {
    for (c.x = first.x - 1; c.x <= last.x + 1; ++c.x) {
      if (!geometry.contains(c) || plan_[c] != CellState::kFree) {
        const Position centre = geometry.centre(c);
        visit(Box(centre - half_cell, centre + half_cell));
      }
    }
  }
}

}  // namespace sfw
