#include "structure_from_wifi/exploration.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "base/validation.h"
#include "exploration/drive_tree.h"

namespace sfw {
namespace {

constexpr double kApartM = 1.0;  // between the goals of a list [m]

}  // namespace

std::string ExplorationGoal::reason() const {
  char text[160];
  std::snprintf(text, sizeof text,
                "%.1f m2 of new free space and new rays worth %.1f m2 in %.0f s; %.0f %% of such "
                "drives touch nothing",
                area_m2, walls_m2, travel_s, 100.0 * arrival);
  return text;
}

std::vector<std::string> validate(const ExplorationConfig& config) {
  Problems problems;
  problems.within("robot_radius", config.robot_radius_m, 0.05, 1.0, "m");
  problems.within("speed", config.speed_m_s, 0.01, 10.0, "m/s");
  problems.within("yaw_rate", config.yaw_rate_rad_s, 0.01, 100.0, "rad/s");
  problems.within("touch_time", config.touch_s, 0.0, 1000.0, "s");
  problems.within("view", config.view_m, 0.1, 5.0, "m");
  problems.within("least_gain", config.least_gain_m2, 0.0, 1000.0, "m2");
  return problems.list();
}

std::vector<Touch> touchesOf(const std::vector<Contact>& contacts,
                             const std::vector<PathPose>& path) {
  std::vector<Touch> touches;
  for (const Contact& contact : contacts) {
    const auto pose =
        std::min_element(path.begin(), path.end(), [&](const PathPose& a, const PathPose& b) {
          return std::abs(a.stamp_ns - contact.stamp_ns) < std::abs(b.stamp_ns - contact.stamp_ns);
        });
    if (pose != path.end() && pose->antenna_in_map != contact.point_in_map) {
      touches.push_back({pose->antenna_in_map, contact.point_in_map});
    }
  }
  return touches;
}

ExplorationView viewOf(const Snapshot& snapshot) {
  const GridGeometry& geometry = snapshot.belief.geometry();
  ExplorationView view{Grid<CellState>(geometry), Grid<float>(geometry), snapshot.walls};
  view.states.cells = snapshot.belief.converted([](const CellBelief& cell) { return cell.state; });
  view.occupied.cells = snapshot.probability.converted([](const CellBelief& cell) {
    return cell.known ? cell.occupied : std::numeric_limits<float>::quiet_NaN();
  });
  for (const AccessPointSummary& summary : snapshot.access_points) {
    if (isPlaced(summary)) {
      view.access_points.push_back(summary.access_point.position);
    }
  }
  for (const PathPose& pose : snapshot.path) {
    view.way.push_back(pose.antenna_in_map);
  }
  view.touches = touchesOf(snapshot.contacts, snapshot.path);
  return view;
}

std::vector<ExplorationGoal> rankGoals(const ExplorationView& view, const RobotPose& robot,
                                       const ExplorationConfig& config, std::size_t most) {
  throwIfAny(validate(config));
  const DriveTree tree(view, robot, config);
  std::vector<Cell> cells;
  std::copy_if(tree.reached().begin(), tree.reached().end(), std::back_inserter(cells),
               [&](Cell c) { return tree.gain(c) >= config.least_gain_m2; });
  std::stable_sort(cells.begin(), cells.end(),
                   [&](Cell a, Cell b) { return tree.rate(a) > tree.rate(b); });
  std::vector<ExplorationGoal> goals;
  for (const Cell c : cells) {
    if (goals.size() == most) {
      break;
    }
    const Position at = tree.geometry().centre(c);
    if (std::all_of(goals.begin(), goals.end(), [&](const ExplorationGoal& other) {
          return (other.position - at).norm() >= kApartM;
        })) {
      goals.push_back(tree.goal(c));
    }
  }
  return goals;
}

std::optional<ExplorationGoal> wayTo(const ExplorationView& view, const RobotPose& robot,
                                     const Position& target, const ExplorationConfig& config) {
  throwIfAny(validate(config));
  const DriveTree tree(view, robot, config);
  const Cell wanted = tree.geometry().cellAt(target);
  if (std::find(tree.reached().begin(), tree.reached().end(), wanted) == tree.reached().end()) {
    return std::nullopt;
  }
  return tree.goal(wanted);
}

}  // namespace sfw
