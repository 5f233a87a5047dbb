#include "simulation/robot/route_strokes.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "grid/contour.h"
#include "grid/for_each_cell.h"
#include "grid/morphology.h"

namespace sfw {
namespace {

constexpr double kLineSpacing = 1.8;    // of lines across a room [m]
constexpr double kShortestLine = 1.0;   // worth driving [m]
constexpr double kWallsReach = 0.9;     // places farther from all strokes are visited [m]
constexpr double kHalfOpening = 0.5;    // of the widest door [m]
constexpr double kPatrolReach = 2.2;    // the same for the middle of rooms on patrol [m]
constexpr double kCornerReach = 3.0;    // the same for the rest of a room [m]
constexpr double kSmallestThing = 1.0;  // circumference of an obstacle that the robot circles [m]

/// The cells of a space at some distance from all walls, by the room that they are in.
Components roomsOf(const ConfigurationSpace& space, double distance) {
  Mask middle(space.geometry());
  forEachCell(space.geometry(), [&](Cell c) {
    middle[c] = space.contains(c) && space.clearance(c) >= distance ? 1 : 0;
  });
  return labelComponents(middle);
}

Mask cellsOf(const Components& components) {
  Mask cells(components.label.geometry);
  for (std::size_t i = 0; i < cells.cells.size(); ++i) {
    cells.cells[i] = components.label.cells[i] != 0 ? 1 : 0;
  }
  return cells;
}

/// The smallest box around cells, in any rotation [cells].
struct TurnedBox {
  Position along;  // unit vector of its longer side
  Position across;
  double along_low, along_high;
  double across_low, across_high;

  double area() const { return (along_high - along_low) * (across_high - across_low); }
  double width() const { return across_high - across_low; }
};

TurnedBox boxAround(const std::vector<Cell>& cells, double angle_rad) {
  const Position x(std::cos(angle_rad), std::sin(angle_rad));
  const Position y(-x.y(), x.x());
  Box box;
  for (const Cell c : cells) {
    box.extend(Position(x.dot(toPosition(c)), y.dot(toPosition(c))));
  }
  const Position& low = box.min();
  const Position& high = box.max();
  if (high.x() - low.x() >= high.y() - low.y()) {
    return {x, y, low.x(), high.x(), low.y(), high.y()};
  }
  return {y, -x, low.y(), high.y(), -high.x(), -low.x()};
}

TurnedBox smallestBoxAround(const std::vector<Cell>& cells) {
  constexpr int kDegrees = 90;
  constexpr double kDegree = kPi / 180.0;
  TurnedBox best = boxAround(cells, 0.0);
  for (int degree = 1; degree < kDegrees; ++degree) {
    const TurnedBox box = boxAround(cells, kDegree * degree);
    // Rounding must not turn the box of a rectangular room.
    best = box.area() < 0.98 * best.area() ? box : best;
  }
  return best;
}

/// Adds the place of a set that is farthest from all previous ones, until none is beyond `reach`.
void addFarthest(const ConfigurationSpace& space, const Mask& places, double reach,
                 DriveDistance& distance, std::vector<Stroke>& strokes) {
  const GridGeometry& g = space.geometry();
  while (true) {
    double farthest = reach;
    Cell best{-1, -1};
    forEachCell(g, [&](Cell c) {
      if (places[c] != 0 && distance[c] > farthest) {
        farthest = distance[c];
        best = c;
      }
    });
    if (best.x < 0) {
      return;
    }
    strokes.push_back({{best}, false, 0});
    distance.add({best});
  }
}

/// Collects the strokes of a drive along the walls.
class WallDrive {
 public:
  WallDrive(const ConfigurationSpace& space, double distance)
      : space_(space),
        rooms_(roomsOf(space, distance)),
        middles_(roomsOf(space, std::max(distance, inCells(kHalfOpening)))) {}

  std::vector<Stroke> strokes() {
    addLoops();
    addLines();
    addNarrowPlaces();
    return std::move(strokes_);
  }

 private:
  double inCells(double metres) const { return metres / space_.geometry().resolution(); }

  /// Adds loops along the outer walls of each room and around obstacles in it.
  void addLoops() {
    // In steps over edges, a circle has a length of eight radii.
    constexpr double kCircle = 8.0;
    std::vector<bool> has_outer(static_cast<std::size_t>(rooms_.count) + 1, false);
    for (std::vector<Cell>& loop : contours(cellsOf(rooms_))) {
      const std::int64_t room = rooms_.label[loop.front()];
      const double of_small = kCircle * space_.clearance(loop.front()) + inCells(kSmallestThing);
      if (has_outer[static_cast<std::size_t>(room)] &&
          static_cast<double>(loop.size()) < of_small) {
        continue;
      }
      has_outer[static_cast<std::size_t>(room)] = true;
      const bool closed = loop.size() > 1;
      strokes_.push_back({std::move(loop), closed, room});
    }
  }

  void addLines() {
    std::int64_t last = 0;
    for (const std::vector<Cell>& border : contours(cellsOf(middles_))) {
      const std::int64_t middle = middles_.label[border.front()];
      // Labels and borders are both in the order of their first cells. No hole begins in a lower
      // row than its room.
      if (middle > last) {
        last = middle;
        addLines(border, middle);
      }
    }
  }

  /// Lines along a room, evenly spaced between the long sides of its middle.
  void addLines(const std::vector<Cell>& border, std::int64_t middle) {
    const TurnedBox box = smallestBoxAround(border);
    const double spacing = inCells(kLineSpacing);
    if (box.width() < spacing / 3.0) {
      return;  // the loop is the middle
    }
    const int lines = std::max(1, static_cast<int>(std::ceil(box.width() / spacing)) - 1);
    for (int i = 1; i <= lines; ++i) {
      addLine(box, box.across_low + box.width() * i / (lines + 1), middle);
    }
  }

  /// The stretches of one line that lie in the middle of the room.
  void addLine(const TurnedBox& box, double across, std::int64_t middle) {
    std::vector<Cell> stretch;
    constexpr double kStep = 0.5;
    double at = box.along_low;
    while (at <= box.along_high + 1.0) {
      const Position place = at * box.along + across * box.across;
      const Cell c{std::llround(place.x()), std::llround(place.y())};
      if (middles_.label.geometry.contains(c) && middles_.label[c] == middle) {
        stretch.push_back(c);
      } else {
        addStretch(stretch);
        stretch.clear();
      }
      at += kStep;
    }
    addStretch(stretch);
  }

  void addStretch(const std::vector<Cell>& stretch) {
    if (stretch.empty() ||
        (toPosition(stretch.back()) - toPosition(stretch.front())).norm() <
            inCells(kShortestLine) ||
        !space_.driveable(stretch.front(), stretch.back(), space_.reach())) {
      return;
    }
    lines_.insert(lines_.end(), stretch.begin(), stretch.end());
    strokes_.push_back({{stretch.front(), stretch.back()}, false, rooms_.label[stretch.front()]});
  }

  /// Visits the places that the strokes leave out, the farthest first.
  void addNarrowPlaces() {
    DriveDistance distance(space_);
    distance.add(lines_);
    for (const Stroke& stroke : strokes_) {
      distance.add(stroke.cells);
    }
    addFarthest(space_, space_.cells(), inCells(kWallsReach), distance, strokes_);
  }

  const ConfigurationSpace& space_;
  Components rooms_;
  Components middles_;  // of rooms, separated at doors even for a small clearance
  std::vector<Stroke> strokes_;
  std::vector<Cell> lines_;
};

/// The cell of each room that is farthest from its walls, by the room's number.
std::vector<Cell> middles(const ConfigurationSpace& space, const Components& rooms) {
  std::vector<Cell> middle(static_cast<std::size_t>(rooms.count) + 1, Cell{-1, -1});
  forEachCell(space.geometry(), [&](Cell c) {
    Cell& best = middle[static_cast<std::size_t>(rooms.label[c])];
    if (rooms.label[c] != 0 && (best.x < 0 || space.clearance(c) > space.clearance(best))) {
      best = c;
    }
  });
  return middle;
}

}  // namespace

std::vector<Stroke> wallStrokes(const ConfigurationSpace& space, double distance) {
  return WallDrive(space, distance).strokes();
}

std::vector<Stroke> patrolStrokes(const ConfigurationSpace& space, double distance) {
  const double resolution = space.geometry().resolution();
  const Components rooms = roomsOf(space, std::max(distance, kHalfOpening / resolution));
  const std::vector<Cell> middle = middles(space, rooms);
  std::vector<Stroke> strokes;
  for (std::int64_t room = 1; room <= rooms.count; ++room) {
    strokes.push_back({{middle[static_cast<std::size_t>(room)]}, false, room});
  }
  DriveDistance driven(space);
  for (const Stroke& stroke : strokes) {
    driven.add(stroke.cells);
  }
  addFarthest(space, cellsOf(rooms), kPatrolReach / resolution, driven, strokes);
  addFarthest(space, space.cells(), kCornerReach / resolution, driven, strokes);
  for (Stroke& stroke : strokes) {
    stroke.room = rooms.label[stroke.cells.front()];
  }
  return strokes;
}

}  // namespace sfw
