#include "exploration/drive_tree.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

#include "base/constants.h"
#include "grid/dijkstra.h"
#include "grid/for_each_cell.h"
#include "grid/ray.h"

namespace sfw {
namespace {

constexpr double kDecisionS = 2.0;    // time before a drive starts: short drives are worth less [s]
constexpr double kNewRayM = 0.4;      // rays to places this far from the way are new [m]
constexpr double kWorthOfWall = 0.1;  // of a new ray through a wall of unknown state [m2/m]
constexpr double kLeastArrival = 0.02;  // drives that are less likely to arrive end
constexpr double kUndecided = 0.3;      // entropy of the walls that rays may decide [bits]

double entropy(double p) {
  return p <= 0.0 || p >= 1.0 ? 0.0 : -(p * std::log2(p) + (1.0 - p) * std::log2(1.0 - p));
}

/// Whether two segments cross.
bool cross(const Position& a, const Position& b, const Position& c, const Position& d) {
  const auto side = [](const Position& from, const Position& to, const Position& at) {
    const Position along = to - from;
    const Position offset = at - from;
    return along.x() * offset.y() - along.y() * offset.x();
  };
  return side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
}

}  // namespace

DriveTree::DriveTree(const ExplorationView& view, const RobotPose& robot,
                     const ExplorationConfig& config)
    : config_(config),
      robot_(robot),
      field_(view, robot.position, config),
      start_(field_.geometry().cellAt(robot.position)),
      nodes_(field_.geometry()),
      time_(field_.geometry(), std::numeric_limits<double>::infinity()),
      access_points_(view.access_points) {
  std::copy_if(view.walls.begin(), view.walls.end(), std::back_inserter(undecided_),
               [](const WallSegment& wall) { return entropy(wall.confidence) > kUndecided; });
  search();
}

double DriveTree::rate(Cell c) const { return gain(c) / (time_[c] + kDecisionS); }

ExplorationGoal DriveTree::goal(Cell c) const {
  const Node& node = nodes_[c];
  ExplorationGoal goal;
  goal.position = geometry().centre(c);
  goal.way = wayTo(c);
  goal.travel_s = time_[c];
  goal.arrival = node.arrival;
  goal.area_m2 = node.area + node.ahead;
  goal.walls_m2 = node.walls;
  goal.rate_m2_s = rate(c);
  return goal;
}

void DriveTree::search() {
  Dijkstra<double> search(time_);
  search.lower(start_, 0.0);
  nodes_[start_].before = start_;
  while (const auto settled = search.settle()) {
    const Cell c = *settled;
    reach(c);
    if (nodes_[c].arrival < kLeastArrival) {
      continue;
    }
    forEachCell(Cell{c.x - 1, c.y - 1}, Cell{c.x + 1, c.y + 1}, [&](Cell next) {
      if (next == c || !geometry().contains(next) || field_.blocked(next)) {
        return;
      }
      const double length = geometry().resolution() * std::hypot(next.x - c.x, next.y - c.y);
      double time = length / config_.speed_m_s +
                    length * static_cast<double>(field_.hazard(next)) * config_.touch_s;
      if (c == start_) {
        time += turnTo(next) / config_.yaw_rate_rad_s;
      }
      if (search.lower(next, time_[c] + time)) {
        nodes_[next].before = c;
      }
    });
  }
}

double DriveTree::turnTo(Cell next) const {
  const double bearing = std::atan2(next.y - start_.y, next.x - start_.x);
  return std::abs(std::remainder(bearing - robot_.yaw_rad, 2.0 * kPi));
}

/// Sums up what is learnt on the way to a settled cell.
void DriveTree::reach(Cell c) {
  Node& node = nodes_[c];
  if (c == start_) {
    return;
  }
  const Node& before = nodes_[node.before];
  const double length =
      geometry().resolution() * std::hypot(c.x - node.before.x, c.y - node.before.y);
  node.arrival = before.arrival * std::exp(-length * static_cast<double>(field_.hazard(c)));
  const double fresh = field_.driven(c) ? 0.0 : field_.newArea(c);
  // A disc of the view's radius r sweeps 2 r for each metre, and covers pi r^2.
  node.area = before.area + node.arrival * fresh * 2.0 * length / (kPi * config_.view_m);
  node.ahead = 0.5 * node.arrival * fresh;
  node.walls = before.walls + node.arrival * length * kWorthOfWall * newRays(c);
  reached_.push_back(c);
}

/// Uncertainty [bits] of the walls that rays from the access points to a new place cross.
double DriveTree::newRays(Cell c) const {
  if (undecided_.empty() || field_.distanceToWay(c) < kNewRayM) {
    return 0.0;
  }
  const Position at = geometry().centre(c);
  double bits = 0.0;
  for (const WallSegment& wall : undecided_) {
    for (const Position& access_point : access_points_) {
      if (cross(access_point, at, wall.from, wall.to)) {
        bits += entropy(wall.confidence);
      }
    }
  }
  return bits;
}

/// Whether a straight drive is as safe as the cells of a way.
bool DriveTree::safe(const Position& from, const Position& to, float worst) const {
  bool open = true;
  Ray(geometry(), from, to).forEachCellWhile([&](Cell c) {
    open = geometry().contains(c) && !field_.blocked(c) && field_.hazard(c) <= worst;
    return open;
  });
  return open;
}

/// The way to a cell with as few corners as are safe.
std::vector<Position> DriveTree::wayTo(Cell c) const {
  std::vector<Cell> cells;
  for (Cell at = c; at != start_; at = nodes_[at].before) {
    cells.push_back(at);
  }
  std::reverse(cells.begin(), cells.end());
  std::vector<Position> way{robot_.position};
  std::size_t next = 0;
  while (next < cells.size()) {
    std::size_t last = next;
    float worst = field_.hazard(cells[next]);
    for (std::size_t i = next + 1; i < cells.size(); ++i) {
      worst = std::max(worst, field_.hazard(cells[i]));
      if (safe(way.back(), geometry().centre(cells[i]), worst)) {
        last = i;
      }
    }
    way.push_back(geometry().centre(cells[last]));
    next = last + 1;
  }
  return way;
}

}  // namespace sfw
