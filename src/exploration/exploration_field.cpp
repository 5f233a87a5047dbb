#include "exploration/exploration_field.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "grid/distance_transform.h"
#include "grid/for_each_cell.h"
#include "grid/morphology.h"
#include "grid/ray.h"

namespace sfw {
namespace {

constexpr double kResolution = 0.1;  // [m]
constexpr double kMargin = 4.0;      // beyond the map [m]
constexpr double kStep = 1.0;        // of the grid's growth [m]
constexpr std::int64_t kMaxCells = 64000000;

/// Share of the cells that stop a robot where nothing is known. With hazards for each kMeetingM, a
/// robot drives 3 m on average before it touches something.
constexpr float kPrior = 0.15F;
constexpr float kCertain = 0.98F;   // of what the robot touched
constexpr float kUntouched = 0.8F;  // largest probability of all else: the map may be wrong
constexpr float kOpaque = 0.5F;     // nothing is seen through cells of a higher probability
constexpr double kMeetingM = 0.5;   // length over which a robot meets what stands beside its way

constexpr double kTouchedHalfM = 0.2;   // half of the wall that a touch proves
constexpr double kBlockedHalfM = 0.1;   // half of what certainly stops the robot
constexpr double kJointM = 2.5;         // touches farther apart say nothing of what is in between
constexpr double kSameLineM = 0.15;     // two touches are of one line this near to it
constexpr double kSameDirection = 0.9;  // and with this cosine of the angle between them
constexpr double kDoorM = 0.7;          // narrower gaps are no doors
constexpr double kDoorRate = 0.25;      // of doors in wider ones [1/m]
constexpr double kSameTouchM = 0.15;    // touches this near are of the same thing
constexpr double kRepeatedM = 0.04;     // for each of them, the robot keeps away farther
constexpr std::ptrdiff_t kMostRepeats = 6;
constexpr double kLeaveM = 0.2;         // around the robot, it may leave what it touches
constexpr double kContinuationM = 2.0;  // to both sides of a touch, a wall may continue
constexpr double kDecayM = 1.0;         // at which its probability has fallen to 1/e
constexpr double kContinues = 0.85;     // probability that it does, beside the touch

GridGeometry geometryAround(const GridGeometry& map, const Position& robot) {
  Box box = map.box();
  box.extend(robot);
  const Position margin(kMargin, kMargin);
  return GridGeometry::covering(Box(box.min() - margin, box.max() + margin), kResolution, kStep,
                                kMaxCells);
}

/// Rate of touches [1/m] where cells hold something with a probability.
float hazardOf(float probability) {
  return -std::log1p(-probability) / static_cast<float>(kMeetingM);
}

void raise(float& value, double probability) {
  value = std::max(value, std::min(static_cast<float>(probability), kCertain));
}

}  // namespace

ExplorationField::ExplorationField(const ExplorationView& view, const Position& robot,
                                   const ExplorationConfig& config)
    : obstacle_(geometryAround(view.states.geometry, robot), kPrior),
      hazard_(geometry()),
      interest_(geometry()),
      blocked_(geometry()),
      driven_(geometry()),
      to_way_(geometry()) {
  for (const Position& at : view.way) {
    const Cell c = geometry().cellAt(at);
    if (geometry().contains(c)) {
      driven_[c] = 1;
    }
  }
  driven_[geometry().cellAt(robot)] = 1;
  to_way_ = distanceTransform(driven_);
  findSight(config.view_m);
  addMap(view);
  addWalls(view.walls);
  addTouches(view.touches);
  clearDriven(config.robot_radius_m);
  findHazards(config.robot_radius_m);
  block(view.touches, robot, config.robot_radius_m);
  findInterest(view);
}

void ExplorationField::findSight(double view_m) {
  const double reach = view_m / geometry().resolution();
  const auto most = static_cast<std::int64_t>(reach);
  std::vector<Cell> offsets;
  forEachCell(Cell{-most, -most}, Cell{most, most}, [&](Cell c) {
    if (std::hypot(c.x, c.y) <= reach) {
      offsets.push_back(c);
    }
  });
  const auto length = [](Cell c) { return c.x * c.x + c.y * c.y; };
  std::stable_sort(offsets.begin(), offsets.end(),
                   [&](Cell a, Cell b) { return length(a) < length(b); });
  for (const Cell c : offsets) {
    // The cell before it on the line of sight: nearer, and the closest to that line.
    Sight sight{c, 0};
    double closest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < sight_.size(); ++i) {
      const Cell d = sight_[i].offset;
      const bool touches = std::abs(c.x - d.x) <= 1 && std::abs(c.y - d.y) <= 1;
      const auto aside = static_cast<double>(std::abs(c.x * d.y - c.y * d.x));
      if (touches && length(d) < length(c) && aside < closest) {
        closest = aside;
        sight.before = i;
      }
    }
    sight_.push_back(sight);
  }
  open_.resize(sight_.size());
}

/// Calls `visit(Cell, Cell)` for each cell here and each cell of the map with the centre of one in
/// the other, so that neither needs to have the finer cells.
template <class Visitor>
void ExplorationField::forEachPair(const GridGeometry& map, Visitor&& visit) const {
  forEachCell(map, [&](Cell c) { visit(geometry().cellAt(map.centre(c)), c); });
  if (map.resolution() > geometry().resolution()) {
    forEachCell(geometry(), [&](Cell c) {
      const Cell of_map = map.cellAt(geometry().centre(c));
      if (map.contains(of_map)) {
        visit(c, of_map);
      }
    });
  }
}

void ExplorationField::addMap(const ExplorationView& view) {
  // A cell here may cover several of the map; the likeliest obstacle counts.
  Grid<float> highest(geometry(), -1.0F);
  const auto take = [&](Cell here, Cell of_map) {
    const float p = view.occupied[of_map];
    if (!std::isnan(p)) {
      highest[here] = std::max(highest[here], std::min(p, kUntouched));
    }
  };
  forEachPair(view.states.geometry, take);
  for (std::size_t i = 0; i < highest.cells.size(); ++i) {
    if (highest.cells[i] >= 0.0F) {
      obstacle_.cells[i] = highest.cells[i];
    }
  }
}

void ExplorationField::addWalls(const std::vector<WallSegment>& walls) {
  for (const WallSegment& wall : walls) {
    Ray(geometry(), wall.from, wall.to).forEachCell([&](Cell c) {
      if (geometry().contains(c)) {
        raise(obstacle_[c], std::min(wall.confidence, static_cast<double>(kUntouched)));
      }
    });
  }
}

void ExplorationField::addTouches(const std::vector<Touch>& touches) {
  Grid<float> open(geometry(), 1.0F);  // probability that no touched wall continues here
  for (const Touch& touch : touches) {
    const Position ahead = (touch.point - touch.robot).normalized();
    const Position aside(-ahead.y(), ahead.x());
    for (const double side : {-1.0, 1.0}) {
      const Position far = touch.point + side * kContinuationM * aside;
      Ray(geometry(), touch.point, far).forEachCellWhile([&](Cell c) {
        // Where the robot drove, the wall has ended.
        if (!geometry().contains(c) || driven_[c] != 0) {
          return false;
        }
        const double along = (geometry().centre(c) - touch.point).norm();
        const double p = along <= kTouchedHalfM
                             ? kCertain
                             : kContinues * std::exp(-(along - kTouchedHalfM) / kDecayM);
        open[c] *= 1.0F - static_cast<float>(p);
        return true;
      });
    }
  }
  for (std::size_t i = 0; i < open.cells.size(); ++i) {
    raise(obstacle_.cells[i], 1.0F - open.cells[i]);
  }
  for (std::size_t i = 0; i < touches.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      joinTouches(touches[i], touches[j]);
    }
  }
}

/// Two touches of one line are mostly of one wall: the nearer they are, the less likely is a door
/// in between.
void ExplorationField::joinTouches(const Touch& a, const Touch& b) {
  const Position ahead = (a.point - a.robot).normalized();
  const Position across = b.point - a.point;
  const double along = std::abs(across.x() * ahead.y() - across.y() * ahead.x());
  if (along > kJointM || std::abs(across.dot(ahead)) > kSameLineM ||
      (b.point - b.robot).normalized().dot(ahead) < kSameDirection) {
    return;
  }
  const double p = kCertain - kDoorRate * std::max(along - kDoorM, 0.0);
  Ray(geometry(), a.point, b.point).forEachCell([&](Cell c) {
    if (geometry().contains(c)) {
      raise(obstacle_[c], p);
    }
  });
}

void ExplorationField::clearDriven(double radius_m) {
  const double reach = std::max(radius_m / geometry().resolution() - 0.5, 0.0);
  for (std::size_t i = 0; i < obstacle_.cells.size(); ++i) {
    if (to_way_.cells[i] <= reach) {
      obstacle_.cells[i] = 0.0F;
    }
  }
}

void ExplorationField::findHazards(double radius_m) {
  const double reach = radius_m / geometry().resolution();
  const auto most = static_cast<std::int64_t>(std::ceil(reach));
  std::vector<Cell> disc;
  forEachCell(Cell{-most, -most}, Cell{most, most}, [&](Cell c) {
    if (std::hypot(c.x, c.y) <= reach + 0.5) {
      disc.push_back(c);
    }
  });
  forEachCell(geometry(), [&](Cell c) {
    float highest = 0.0F;
    for (const Cell offset : disc) {
      const Cell at{c.x + offset.x, c.y + offset.y};
      highest = std::max(highest, geometry().contains(at) ? obstacle_[at] : kPrior);
    }
    highest = driven(c) ? 0.0F : highest;
    hazard_[c] = hazardOf(highest);
  });
}

void ExplorationField::block(const std::vector<Touch>& touches, const Position& robot,
                             double radius_m) {
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const Touch& touch = touches[i];
    // A robot that touches the same thing again does not pass as near as it believes.
    const auto repeated = std::count_if(
        touches.begin(), touches.begin() + static_cast<std::ptrdiff_t>(i),
        [&](const Touch& other) { return (other.point - touch.point).norm() < kSameTouchM; });
    const double reach = radius_m + kRepeatedM * static_cast<double>(std::min<std::ptrdiff_t>(
                                                     repeated, kMostRepeats));
    const Position ahead = (touch.point - touch.robot).normalized();
    const Position aside(-ahead.y(), ahead.x());
    const Position range(reach + kBlockedHalfM, reach + kBlockedHalfM);
    forEachCell(geometry().cellAt(touch.point - range), geometry().cellAt(touch.point + range),
                [&](Cell c) {
                  const Position offset = geometry().centre(c) - touch.point;
                  const double along = std::max(std::abs(offset.dot(aside)) - kBlockedHalfM, 0.0);
                  // The robot itself must come away.
                  const bool here = (geometry().centre(c) - robot).norm() < kLeaveM;
                  if (geometry().contains(c) && std::hypot(along, offset.dot(ahead)) < reach) {
                    blocked_[c] = here ? 0 : 1;
                    hazard_[c] = hazardOf(kCertain);
                  }
                });
  }
}

template <class Visitor>
void ExplorationField::forEachSeen(Cell from, Visitor&& visit) const {
  for (std::size_t i = 0; i < sight_.size(); ++i) {
    const Cell at{from.x + sight_[i].offset.x, from.y + sight_[i].offset.y};
    const bool visible = (i == 0 || open_[sight_[i].before] != 0) && geometry().contains(at);
    open_[i] = static_cast<std::uint8_t>(visible && obstacle_[at] <= kOpaque);
    if (visible) {
      visit(at);
    }
  }
}

void ExplorationField::findInterest(const ExplorationView& view) {
  for (std::size_t i = 0; i < interest_.cells.size(); ++i) {
    interest_.cells[i] = 1.0F - obstacle_.cells[i];
  }
  forEachPair(view.states.geometry, [&](Cell here, Cell of_map) {
    if (view.states[of_map] != CellState::kUnknown) {
      interest_[here] = 0.0F;
    }
  });
  forEachCell(geometry(), [&](Cell c) {
    if (driven(c)) {
      forEachSeen(c, [&](Cell seen) { interest_[seen] = 0.0F; });
    }
  });
}

double ExplorationField::newArea(Cell c) const {
  double sum = 0.0;
  forEachSeen(c, [&](Cell seen) { sum += static_cast<double>(interest_[seen]); });
  return sum * geometry().resolution() * geometry().resolution();
}

}  // namespace sfw
