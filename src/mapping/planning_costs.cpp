#include "structure_from_wifi/planning_costs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "grid/for_each_cell.h"
#include "grid/mask.h"
#include "grid/morphology.h"
#include "grid/ray.h"

namespace sfw {
namespace {

/// A disc of cells: for each row from the lowest, the cells to either side of the centre's column.
std::vector<std::int64_t> halfWidths(double radius_cells) {
  const auto reach = static_cast<std::int64_t>(radius_cells);
  std::vector<std::int64_t> widths;
  for (std::int64_t y = -reach; y <= reach; ++y) {
    const double square = radius_cells * radius_cells - static_cast<double>(y * y);
    widths.push_back(static_cast<std::int64_t>(std::sqrt(std::max(square, 0.0))));
  }
  return widths;
}

/// The probability of being occupied, 0 where nothing is known.
Grid<float> risksOf(const BeliefMap& probability) {
  Grid<float> risks(probability.geometry());
  risks.cells = probability.converted(
      [](const CellBelief& cell) { return cell.known ? cell.occupied : 0.0F; });
  return risks;
}

float highestAround(const Grid<float>& risks, Cell centre, const std::vector<std::int64_t>& disc) {
  const auto reach = static_cast<std::int64_t>(disc.size() / 2);
  float highest = 0.0F;
  for (std::int64_t y = std::max<std::int64_t>(centre.y - reach, 0);
       y <= std::min(centre.y + reach, risks.geometry.height() - 1); ++y) {
    const std::int64_t width = disc[static_cast<std::size_t>(y - centre.y + reach)];
    const std::int64_t left = std::max<std::int64_t>(centre.x - width, 0);
    const std::int64_t right = std::min(centre.x + width, risks.geometry.width() - 1);
    const float* const row = &risks[{0, y}];
    highest = std::max(highest, *std::max_element(row + left, row + right + 1));
  }
  return highest;
}

std::int8_t costOf(float risk) {
  constexpr float kHighRisk = 0.25F;
  const float share = std::min(risk / kHighRisk, 1.0F);
  return static_cast<std::int8_t>(std::lround(static_cast<float>(kDearestCost) * share));
}

/// Cells that the robot clearly covered at its poses. What it touches lies at the edge of its
/// footprint, so the outermost half of a cell does not count.
Mask footprintOf(const Snapshot& snapshot, double radius_m) {
  Mask poses(snapshot.belief.geometry());
  for (const PathPose& pose : snapshot.path) {
    const Cell c = poses.geometry.cellAt(pose.antenna_in_map);
    if (poses.geometry.contains(c)) {
      poses[c] = 1;
    }
  }
  return dilated(poses, std::max(radius_m / poses.geometry.resolution() - 0.5, 0.0));
}

/// The direction in which the robot touched something, of length 1. Nothing without a pose, or if
/// the contact is not beside it.
std::optional<Position> directionOf(const Contact& contact, const std::vector<PathPose>& path) {
  const auto begin = std::partition_point(
      path.begin(), path.end(), [&](const PathPose& pose) { return pose.robot < contact.robot; });
  const auto end = std::partition_point(
      begin, path.end(), [&](const PathPose& pose) { return pose.robot == contact.robot; });
  const auto after = std::partition_point(
      begin, end, [&](const PathPose& pose) { return pose.stamp_ns < contact.stamp_ns; });
  std::optional<Position> ahead;
  // The robot moves between two poses; it touches with its front at the one that is nearer.
  for (auto pose = after == begin ? after : after - 1; pose != end && pose <= after; ++pose) {
    const Position offset = contact.point_in_map - pose->antenna_in_map;
    if (!ahead || offset.squaredNorm() < ahead->squaredNorm()) {
      ahead = offset;
    }
  }
  constexpr double kLeast = 1e-3;    // [m]
  constexpr double kFarthest = 2.0;  // [m]
  if (!ahead || ahead->norm() < kLeast || ahead->norm() > kFarthest) {
    return std::nullopt;
  }
  return ahead->normalized();
}

/// A wall that the robot touched, across the direction of the touch.
struct TouchedWall {
  Position from, to, ahead;
};

std::vector<TouchedWall> touchedWalls(const Snapshot& snapshot, double footprint_radius_m) {
  constexpr double kHalfWidth = 0.2;  // [m], to both sides of a contact
  constexpr double kAlike = 0.5;      // cosine of 60 degrees
  std::vector<TouchedWall> walls;
  std::vector<TouchedWall> joints;
  for (const Contact& contact : snapshot.contacts) {
    const std::optional<Position> ahead = directionOf(contact, snapshot.path);
    if (!ahead) {
      continue;
    }
    const Position aside = kHalfWidth * Position(-ahead->y(), ahead->x());
    const Position& at = contact.point_in_map;
    for (const TouchedWall& other : walls) {
      // The robot does not fit between two such walls.
      const Position middle = 0.5 * (other.from + other.to);
      if ((middle - at).norm() <= 2.0 * (kHalfWidth + footprint_radius_m) &&
          other.ahead.dot(*ahead) >= kAlike) {
        joints.push_back({middle, at, *ahead});
      }
    }
    walls.push_back({at - aside, at + aside, *ahead});
  }
  walls.insert(walls.end(), joints.begin(), joints.end());
  return walls;
}

/// Marks the walls that the robot touched. The map calls cells near the way of the robot free, also
/// those behind such a wall: here they are unknown, up to where the robot was.
void addTouchedWalls(const Snapshot& snapshot, double footprint_radius_m,
                     Grid<std::int8_t>& costs) {
  constexpr double kDepth = 1.0;  // [m]
  if (snapshot.contacts.empty()) {
    return;
  }
  const Mask footprint = footprintOf(snapshot, footprint_radius_m);
  const auto isOpen = [&](Cell c) { return costs.geometry.contains(c) && footprint[c] == 0; };
  const std::vector<TouchedWall> walls = touchedWalls(snapshot, footprint_radius_m);
  for (const TouchedWall& wall : walls) {
    Ray(costs.geometry, wall.from, wall.to).forEachCell([&](Cell c) {
      const Position at = costs.geometry.centre(c);
      if (!isOpen(c)) {
        return;
      }
      Ray(costs.geometry, at, at + kDepth * wall.ahead).forEachCellWhile([&](Cell behind) {
        const bool open = isOpen(behind);
        if (open && costs[behind] != kOccupiedCost) {
          costs[behind] = kUnknownCost;
        }
        return open;
      });
    });
  }
  for (const TouchedWall& wall : walls) {
    Ray(costs.geometry, wall.from, wall.to).forEachCell([&](Cell c) {
      if (isOpen(c)) {
        costs[c] = kOccupiedCost;
      }
    });
  }
}

}  // namespace

Grid<std::int8_t> planningCosts(const Snapshot& snapshot, double footprint_radius_m) {
  // The readings do not place a wall better, and a robot does not follow its plan better.
  constexpr double kDeviation = 0.15;  // [m]
  const GridGeometry& geometry = snapshot.belief.geometry();
  const std::vector<std::int64_t> disc =
      halfWidths((footprint_radius_m + kDeviation) / geometry.resolution());
  const Grid<float> risks = risksOf(snapshot.probability);
  Grid<std::int8_t> costs(geometry, kUnknownCost);
  forEachCell(geometry, [&](Cell c) {
    const CellState state = snapshot.belief.state(c);
    if (state == CellState::kOccupied) {
      costs[c] = kOccupiedCost;
    } else if (state == CellState::kFree) {
      costs[c] = costOf(highestAround(risks, c, disc));
    }
  });
  addTouchedWalls(snapshot, footprint_radius_m, costs);
  return costs;
}

}  // namespace sfw
