#include "output/map_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

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
    if (isPlaced(summary)) {
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

/// A colour between two others.
Colour mixed(const Colour& from, const Colour& to, double share) {
  Colour colour;
  for (std::size_t i = 0; i < colour.size(); ++i) {
    colour[i] = (1.0 - share) * from[i] + share * to[i];
  }
  return colour;
}

/// A wall that is not sure looks pale.
Colour wallColour(double confidence) {
  constexpr Colour kSureWall{0.55, 0.00, 0.00};
  return mixed(Canvas::kFree, kSureWall, confidence);
}

// Losses of signals are drawn in steps.
constexpr int kLossSteps = 8;
constexpr double kHighestLossDb = 2.0;  // larger ones look alike
constexpr Colour kLoss{0.80, 0.35, 0.00};

/// The step of a loss, from 0 to kLossSteps.
int lossStep(float loss_db) {
  const double share = std::clamp(static_cast<double>(loss_db) / kHighestLossDb, 0.0, 1.0);
  return static_cast<int>(std::lround(share * kLossSteps));
}

/// The colour of a cell with the highest loss in a map, where the loss must not hide the map.
Colour shaded(const Colour& ground) {
  constexpr double kShare = 0.6;
  return mixed(ground, kLoss, kShare);
}

/// Fills the cells for which `chosen(Cell)` holds, from `none` to `highest` by their losses.
template <class Chosen>
void fillLosses(const Grid<float>& loss_db, const Colour& none, const Colour& highest,
                Canvas& canvas, Chosen&& chosen) {
  Grid<std::int8_t> steps(loss_db.geometry);
  forEachCell(loss_db.geometry, [&](Cell c) {
    steps[c] = static_cast<std::int8_t>(chosen(c) ? lossStep(loss_db[c]) : 0);
  });
  for (int step = 1; step <= kLossSteps; ++step) {
    canvas.fillCells(loss_db.geometry, mixed(none, highest, static_cast<double>(step) / kLossSteps),
                     [&](Cell c) { return steps[c] == step; });
  }
}

void fillStates(const Snapshot& snapshot, Canvas& canvas) {
  const BeliefMap& belief = snapshot.belief;
  for (const auto& [state, colour] : {std::pair(CellState::kUnknown, Canvas::kUnknown),
                                      {CellState::kFree, Canvas::kFree},
                                      {CellState::kOccupied, Canvas::kOccupied}}) {
    const auto has_state = [&belief, wanted = state](Cell c) { return belief.state(c) == wanted; };
    if (state != CellState::kUnknown) {  // that is the colour of the page
      canvas.fillCells(belief.geometry(), colour, has_state);
    }
    if (state != CellState::kOccupied && snapshot.tomography) {
      fillLosses(snapshot.tomography->wall_loss, colour, shaded(colour), canvas, has_state);
    }
  }
}

/// The colours of areas and walls in a map.
std::vector<LegendEntry> mapLegend(const Snapshot& snapshot) {
  std::vector<LegendEntry> legend{{Canvas::kFree, "free"}, {Canvas::kOccupied, "occupied"}};
  if (!snapshot.walls.empty()) {
    legend.push_back({wallColour(1.0), "wall"});
    legend.push_back({wallColour(0.5), "unsure wall"});
  }
  if (snapshot.tomography) {
    legend.push_back({shaded(Canvas::kFree), formatted("%g dB lost", kHighestLossDb)});
  }
  return legend;
}

/// Radios at one place (the bands of one router) share a label.
void drawAccessPoints(const Snapshot& snapshot, Canvas& canvas) {
  std::set<std::pair<double, double>> named;
  for (const AccessPointSummary& summary : snapshot.access_points) {
    if (!isPlaced(summary) || summary.radio) {
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
  constexpr double kWallWidth = 6.0;  // [px]
  Canvas canvas(shownArea(snapshot));
  fillStates(snapshot, canvas);
  canvas.drawAxes();
  for (const WallSegment& wall : snapshot.walls) {
    canvas.drawLine(wall.from, wall.to, wallColour(wall.confidence), kWallWidth);
  }
  int most = 0;
  std::vector<std::pair<Position, Colour>> path;
  path.reserve(snapshot.path.size());
  for (const PathPose& pose : snapshot.path) {
    path.emplace_back(pose.antenna_in_map, wallCountColour(pose.walls));
    most = std::max(most, pose.walls);
  }
  canvas.drawDots(path);
  drawAccessPoints(snapshot, canvas);
  std::vector<LegendEntry> legend;
  for (int walls = 0; walls <= most; ++walls) {
    legend.push_back({wallCountColour(walls), std::to_string(walls)});
  }
  canvas.drawHeader(mapLegend(snapshot));
  canvas.drawFooter("fewest walls to an access point:", legend);
  return canvas.png();
}

std::string renderWallLoss(const Grid<float>& wall_loss_db, const Snapshot& snapshot) {
  constexpr Colour kPath{0.55, 0.60, 0.65};
  Canvas canvas(shownArea(snapshot));
  canvas.fillArea(Canvas::kFree);
  fillLosses(wall_loss_db, Canvas::kFree, kLoss, canvas, [](Cell) { return true; });
  canvas.drawAxes();
  std::vector<std::pair<Position, Colour>> path;
  path.reserve(snapshot.path.size());
  for (const PathPose& pose : snapshot.path) {
    path.emplace_back(pose.antenna_in_map, kPath);
  }
  canvas.drawDots(path);
  drawAccessPoints(snapshot, canvas);
  std::vector<LegendEntry> legend;
  for (int step = 0; step <= kLossSteps; step += 2) {
    const double share = static_cast<double>(step) / kLossSteps;
    legend.push_back({mixed(Canvas::kFree, kLoss, share),
                      formatted(step < kLossSteps ? "%g" : "%g and more", share * kHighestLossDb)});
  }
  canvas.drawFooter("signal that a cell takes away [dB], by radio alone:", legend);
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
