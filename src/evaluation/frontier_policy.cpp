#include "evaluation/frontier_policy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "grid/for_each_cell.h"
#include "grid/mask.h"
#include "grid/morphology.h"

namespace sfw {
namespace {

// The values of explore_lite 2.1 in its explore.launch.
constexpr double kPotentialScale = 3.0;
constexpr double kGainScale = 1.0;
constexpr double kMinFrontierM = 0.3;  // 0.75 by default, before frontiers are cut
constexpr double kLatticeM = 1.0;
constexpr double kProgressTimeoutS = 30.0;
constexpr double kPlannerPeriodS = 3.0;  // a planner frequency of 0.33 Hz
constexpr double kMapPeriodS = 10.0;
constexpr double kBlacklistM = 0.25;  // five cells of its costmap

constexpr double kNearM = 0.4;  // the robot's own cell may be unknown; free cells this near count

}  // namespace

FrontierPolicy::FrontierPolicy() : driver_(WayDriver::Config()) {}

void FrontierPolicy::setMap(const Snapshot& map) { view_ = viewOf(map); }

DriveCommand FrontierPolicy::step(const RobotPose& pose, const std::optional<Position>& touched,
                                  double now_s) {
  if (way_.empty() || (way_.back() - pose.position).norm() > 0.05) {
    way_.push_back(pose.position);
  }
  if (touched && !in_touch_) {
    touches_.push_back({pose.position, *touched});
  }
  in_touch_ = touched.has_value();
  state_ = driver_.step(pose, in_touch_, now_s);
  const bool driving = state_ == Driver::State::kDriving;
  if (now_s - chosen_s_ < (driving ? kMapPeriodS : kPlannerPeriodS)) {
    return driver_.command();
  }
  chosen_s_ = now_s;
  choose(pose, now_s);
  return driver_.command();
}

void FrontierPolicy::choose(const RobotPose& pose, double now_s) {
  view_->way = way_;
  view_->touches = touches_;
  if (goal_) {
    const double distance = (*goal_ - pose.position).norm();
    if (distance < least_distance_m_ - 0.1) {
      least_distance_m_ = distance;
      progress_s_ = now_s;
    } else if (now_s - progress_s_ > kProgressTimeoutS) {
      blacklist_.push_back(*goal_);
      goal_.reset();
    }
  }
  std::vector<Frontier> all = frontiers(pose.position);
  std::stable_sort(all.begin(), all.end(),
                   [](const Frontier& a, const Frontier& b) { return a.cost < b.cost; });
  for (const Frontier& frontier : all) {
    if (blacklisted(frontier.centroid)) {
      continue;
    }
    const auto drive = wayTo(*view_, pose, frontier.centroid, ExplorationConfig());
    if (!drive) {
      blacklist_.push_back(frontier.centroid);
      continue;
    }
    if (!goal_ || (*goal_ - frontier.centroid).norm() > kBlacklistM) {
      least_distance_m_ = std::numeric_limits<double>::infinity();
      progress_s_ = now_s;
    }
    goal_ = frontier.centroid;
    driver_.follow(drive->way);
    return;
  }
  finished_ = true;
}

bool FrontierPolicy::blacklisted(const Position& goal) const {
  return std::any_of(blacklist_.begin(), blacklist_.end(), [&](const Position& other) {
    return (other - goal).cwiseAbs().maxCoeff() < kBlacklistM;
  });
}

std::vector<FrontierPolicy::Frontier> FrontierPolicy::frontiers(const Position& robot) const {
  const GridGeometry& geometry = view_->states.geometry;
  Mask free(geometry);
  forEachCell(geometry, [&](Cell c) {
    free[c] = static_cast<std::uint8_t>(view_->states[c] == CellState::kFree);
  });
  const Components parts = labelComponents(free);
  std::int64_t own = 0;
  double nearest = kNearM;
  forEachCell(geometry, [&](Cell c) {
    const double distance = (geometry.centre(c) - robot).norm();
    if (free[c] != 0 && distance < nearest) {
      nearest = distance;
      own = parts.label[c];
    }
  });
  Mask border(geometry);
  forEachCell(geometry, [&](Cell c) {
    if (view_->states[c] != CellState::kUnknown) {
      return;
    }
    for (const Cell next :
         {Cell{c.x - 1, c.y}, Cell{c.x + 1, c.y}, Cell{c.x, c.y - 1}, Cell{c.x, c.y + 1}}) {
      if (own != 0 && geometry.contains(next) && parts.label[next] == own) {
        border[c] = 1;
      }
    }
  });
  const Components lines = labelComponents(border, Connectivity::kEdgesAndCorners);
  const auto key = [&](Cell c) {
    const Position at = geometry.centre(c) / kLatticeM;
    return std::make_tuple(lines.label[c], std::floor(at.x()), std::floor(at.y()));
  };
  struct Sum {
    Position position = Position::Zero();
    double cells = 0.0;
    double nearest = std::numeric_limits<double>::infinity();
  };
  std::map<decltype(key({})), Sum> sums;
  forEachCell(geometry, [&](Cell c) {
    if (lines.label[c] > 0) {
      Sum& sum = sums[key(c)];
      const Position at = geometry.centre(c);
      sum.position += at;
      sum.cells += 1.0;
      sum.nearest = std::min(sum.nearest, (at - robot).norm());
    }
  });
  std::vector<Frontier> found;
  for (const auto& [where, sum] : sums) {
    const double length = sum.cells * geometry.resolution();
    if (length >= kMinFrontierM) {
      found.push_back(
          {sum.position / sum.cells,
           kPotentialScale * sum.nearest * geometry.resolution() - kGainScale * length});
    }
  }
  return found;
}

}  // namespace sfw
