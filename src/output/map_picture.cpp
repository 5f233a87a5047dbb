#include "output/map_picture.h"

#include <algorithm>
#include <set>

#include "files/canvas.h"
#include "files/text.h"
#include "grid/for_each_cell.h"

namespace sfw {
namespace {

/// The part of the map in the picture: known cells, path and access points, with a margin.
Box shownArea(const Snapshot& snapshot) {
  const GridGeometry& geometry = snapshot.belief.geometry();
  Box area;
  for (const PathPose& pose : snapshot.path) {
    area.extend(pose.antenna_in_map);
  }
  for (const AccessPointSummary& summary : snapshot.access_points) {
    if (hasPosition(summary)) {
      area.extend(summary.access_point.position);
    }
  }
  forEachCell(geometry, [&](Cell c) {
    if (snapshot.belief.state(c) != CellState::kUnknown) {
      area.extend(geometry.centre(c));
    }
  });
  constexpr double kAir = 0.5;  // [m]
  return {area.min().array() - kAir, area.max().array() + kAir};
}

/// Radios at one place (the bands of one router) share a label.
void drawAccessPoints(const Snapshot& snapshot, Canvas& canvas) {
  std::set<std::pair<double, double>> named;
  for (const AccessPointSummary& summary : snapshot.access_points) {
    if (!hasPosition(summary)) {
      continue;
    }
    const AccessPoint& access_point = summary.access_point;
    const Position& at = access_point.position;
    const std::string name =
        access_point.name.empty() ? access_point.bssid.str() : asUtf8(access_point.name);
    canvas.drawAccessPoint(at, named.emplace(at.x(), at.y()).second ? name : "");
  }
}

}  // namespace

Colour wallCountColour(int walls) {
  if (walls < 0) {
    return {0.5, 0.5, 0.5};
  }
  constexpr std::array<Colour, 8> kScale{{{0.90, 0.10, 0.10},
                                          {0.10, 0.70, 0.15},
                                          {0.10, 0.30, 0.95},
                                          {0.95, 0.80, 0.05},
                                          {0.95, 0.50, 0.05},
                                          {0.05, 0.75, 0.80},
                                          {0.85, 0.30, 0.75},
                                          {0.45, 0.30, 0.20}}};
  return kScale[std::min(static_cast<std::size_t>(walls), kScale.size() - 1)];
}

std::string renderPicture(const Snapshot& snapshot) {
  Canvas canvas(shownArea(snapshot));
  const BeliefMap& belief = snapshot.belief;
  canvas.fillCells(belief.geometry(), Canvas::kFree,
                   [&](Cell c) { return belief.state(c) == CellState::kFree; });
  canvas.fillCells(belief.geometry(), Canvas::kOccupied,
                   [&](Cell c) { return belief.state(c) == CellState::kOccupied; });
  int most = 0;
  for (const PathPose& pose : snapshot.path) {
    canvas.drawDot(pose.antenna_in_map, wallCountColour(pose.walls));
    most = std::max(most, pose.walls);
  }
  drawAccessPoints(snapshot, canvas);
  std::vector<LegendEntry> legend;
  for (int walls = 0; walls <= most; ++walls) {
    legend.push_back({wallCountColour(walls), std::to_string(walls)});
  }
  canvas.drawFooter("fewest walls to an access point:", legend);
  return canvas.png();
}

std::string renderPicture(const Grid<CellState>& states, const Position& access_point) {
  Box area = states.geometry.box();
  area.extend(access_point);
  Canvas canvas(area);
  canvas.fillCells(states.geometry, Canvas::kFree,
                   [&](Cell c) { return states[c] == CellState::kFree; });
  canvas.fillCells(states.geometry, Canvas::kOccupied,
                   [&](Cell c) { return states[c] == CellState::kOccupied; });
  canvas.drawAccessPoint(access_point, "access point");
  canvas.drawFooter("", {{Canvas::kFree, "free"}, {Canvas::kOccupied, "wall"}});
  return canvas.png();
}

}  // namespace sfw
