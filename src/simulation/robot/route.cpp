#include "simulation/robot/route.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string>

#include "base/constants.h"
#include "base/validation.h"
#include "grid/segment.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

void requirePositive(double value, const char* name) {
  if (!(std::isfinite(value) && value > 0.0)) {
    throw std::invalid_argument(std::string(name) + " must be finite and positive");
  }
}

std::string toText(const Position& point) {
  char text[64];
  std::snprintf(text, sizeof text, "(%.2f, %.2f)", point.x(), point.y());
  return text;
}

/// A cell that is not free and too near to the segment; the lowest row first.
std::optional<Cell> findObstacle(const Grid<CellState>& plan, const Position& a, const Position& b,
                                 double radius_m) {
  const GridGeometry& geometry = plan.geometry;
  const double reach = radius_m + std::sqrt(0.5) * geometry.resolution();
  const Cell first = geometry.cellAt(a.cwiseMin(b) - Position::Constant(reach));
  const Cell last = geometry.cellAt(a.cwiseMax(b) + Position::Constant(reach));
  Cell c;
  for (c.y = first.y; c.y <= last.y; ++c.y) {
    for (c.x = first.x; c.x <= last.x; ++c.x) {
      const bool free = geometry.contains(c) && plan[c] == CellState::kFree;
      if (!free && distanceToSegment(geometry.centre(c), a, b) < reach) {
        return c;
      }
    }
  }
  return std::nullopt;
}

std::string obstacleText(const Grid<CellState>& plan, Cell c) {
  const char* what = " is outside the plan";
  if (plan.geometry.contains(c)) {
    what = plan[c] == CellState::kOccupied ? " is occupied" : " is unknown";
  }
  return toText(plan.geometry.centre(c)) + what;
}

}  // namespace

Route::Route(const std::vector<Position>& way_points, double speed_m_s, double yaw_rate_rad_s) {
  requirePositive(speed_m_s, "speed_m_s");
  requirePositive(yaw_rate_rad_s, "yaw_rate_rad_s");
  for (std::size_t i = 1; i < way_points.size(); ++i) {
    const Position along = way_points[i] - way_points[i - 1];
    if (along.norm() == 0.0) {
      continue;
    }
    Leg leg{};
    leg.from = way_points[i - 1];
    leg.to = way_points[i];
    leg.yaw_rad = std::atan2(along.y(), along.x());
    if (!legs_.empty()) {
      const Leg& last = legs_.back();
      leg.start_s = last.end_s;
      leg.driven_m = last.driven_m + (last.to - last.from).norm();
      leg.turn_rad = std::remainder(leg.yaw_rad - last.yaw_rad, 2.0 * kPi);
    }
    leg.drive_s = leg.start_s + std::abs(leg.turn_rad) / yaw_rate_rad_s;
    leg.end_s = leg.drive_s + along.norm() / speed_m_s;
    legs_.push_back(leg);
  }
  if (legs_.empty()) {
    throw InputError("a route needs at least two different way points");
  }
}

double Route::duration() const { return legs_.back().end_s; }

const Route::Leg& Route::legAt(double time_s) const {
  const auto next = std::upper_bound(legs_.begin() + 1, legs_.end(), time_s,
                                     [](double t, const Leg& leg) { return t < leg.start_s; });
  return *(next - 1);
}

RobotPose Route::poseAt(double time_s) const {
  const double time = std::clamp(time_s, 0.0, duration());
  const Leg& leg = legAt(time);
  if (time < leg.drive_s) {
    const double to_go = (leg.drive_s - time) / (leg.drive_s - leg.start_s);
    return {leg.from, leg.yaw_rad - to_go * leg.turn_rad};
  }
  const double share = (time - leg.drive_s) / (leg.end_s - leg.drive_s);
  return {leg.from + share * (leg.to - leg.from), leg.yaw_rad};
}

double Route::drivenAt(double time_s) const {
  const Leg& leg = legAt(std::clamp(time_s, 0.0, duration()));
  return leg.driven_m + (poseAt(time_s).position - leg.from).norm();
}

void requireFree(const Grid<CellState>& plan, const std::vector<Position>& way_points,
                 double radius_m) {
  std::vector<std::string> problems;
  const auto name = [&](std::size_t i) {
    return "way point " + std::to_string(i + 1) + " " + toText(way_points[i]);
  };
  bool last_is_free = false;
  for (std::size_t i = 0; i < way_points.size(); ++i) {
    const std::optional<Cell> obstacle = findObstacle(plan, way_points[i], way_points[i], radius_m);
    if (obstacle) {
      problems.push_back(name(i) + " is not free: " + obstacleText(plan, *obstacle));
    } else if (last_is_free) {
      const auto between = findObstacle(plan, way_points[i - 1], way_points[i], radius_m);
      if (between) {
        problems.push_back("the stretch from " + name(i - 1) + " to " + name(i) +
                           " is not free: " + obstacleText(plan, *between));
      }
    }
    last_is_free = !obstacle;
  }
  throwIfAny(problems);
}

}  // namespace sfw
