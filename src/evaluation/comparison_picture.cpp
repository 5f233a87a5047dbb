#include "evaluation/comparison_picture.h"

#include "evaluation/evaluation_truth.h"
#include "evaluation/samples.h"
#include "files/canvas.h"
#include "grid/distance_transform.h"
#include "grid/for_each_cell.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

constexpr double kTolerance = 0.1;  // of walls [m]

/// The agreement of map and truth in a cell.
enum class Verdict { kFreeMissed, kFreeFound, kWallMissed, kWallFound, kWallFalse, kWallLost };

struct Meaning {
  Verdict verdict;
  Colour colour;
  const char* text;
};
constexpr Meaning kMeanings[] = {{Verdict::kFreeFound, {1.0, 1.0, 1.0}, "free"},
                                 {Verdict::kFreeMissed, {0.72, 0.86, 0.72}, "free, missed"},
                                 {Verdict::kWallFound, {0.10, 0.10, 0.12}, "wall"},
                                 {Verdict::kWallMissed, {0.45, 0.60, 0.85}, "wall, missed"},
                                 {Verdict::kWallLost, {0.85, 0.10, 0.10}, "wall taken for free"},
                                 {Verdict::kWallFalse, {0.95, 0.60, 0.10}, "wall where free"}};
constexpr Colour kPath{0.55, 0.45, 0.75};
constexpr Colour kPanelPath{0.20, 0.50, 0.90};  // where the path covers no colours
constexpr Colour kTrueWall{0.93, 0.55, 0.50};

/// Distance to the nearest wall [cells].
Grid<double> toWalls(const Grid<CellState>& states) {
  return distanceTransform(cellsOfState(states, CellState::kOccupied));
}

class Comparison {
 public:
  explicit Comparison(const EvaluationInput& input)
      : truth_(input.truth),
        map_(sampled(input.map, input.truth.geometry, CellState::kUnknown)),
        to_true_wall_(toWalls(truth_)),
        to_map_wall_(toWalls(map_)),
        reach_(kTolerance / truth_.geometry.resolution() + 1e-9) {}

  bool isKnown(Cell c) const { return truth_[c] != CellState::kUnknown; }

  Verdict verdict(Cell c) const {
    if (truth_[c] == CellState::kOccupied) {
      return to_map_wall_[c] <= reach_     ? Verdict::kWallFound
             : map_[c] == CellState::kFree ? Verdict::kWallLost
                                           : Verdict::kWallMissed;
    }
    if (map_[c] == CellState::kOccupied && to_true_wall_[c] > reach_) {
      return Verdict::kWallFalse;
    }
    return map_[c] == CellState::kUnknown ? Verdict::kFreeMissed : Verdict::kFreeFound;
  }

 private:
  const Grid<CellState>& truth_;
  const Grid<CellState> map_;
  const Grid<double> to_true_wall_;
  const Grid<double> to_map_wall_;
  const double reach_;  // [cells]
};

/// The known part of the truth, the path and the access points, with a margin.
Box shownArea(const EvaluationInput& input) {
  const GridGeometry& geometry = input.truth.geometry;
  Box area;
  forEachCell(geometry, [&](Cell c) {
    if (input.truth[c] != CellState::kUnknown) {
      area.extend(geometry.centre(c));
    }
  });
  if (area.isEmpty()) {
    throw InputError("the truth has no known cell; check that its file is the true map");
  }
  for (const Position& pose : input.path) {
    area.extend(pose);
  }
  for (const Position& access_point : input.access_points) {
    area.extend(access_point);
  }
  constexpr double kAir = 0.5;  // [m]
  return {area.min().array() - kAir, area.max().array() + kAir};
}

void fillState(const Grid<CellState>& states, CellState wanted, const Colour& colour,
               Canvas& canvas) {
  canvas.fillCells(states.geometry, colour, [&](Cell c) { return states[c] == wanted; });
}

void drawMarks(const EvaluationInput& input, const Colour& path, Canvas& canvas) {
  std::vector<std::pair<Position, Colour>> dots;
  for (const Position& pose : input.path) {
    dots.emplace_back(pose, path);
  }
  canvas.drawDots(dots);
  for (const Position& access_point : input.access_points) {
    canvas.drawAccessPoint(access_point, "");
  }
}

}  // namespace

std::string renderComparison(const EvaluationInput& input) {
  const GridGeometry& geometry = input.truth.geometry;
  Canvas canvas(shownArea(input));
  const Comparison comparison(input);
  std::vector<LegendEntry> legend;
  for (const Meaning& meaning : kMeanings) {
    canvas.fillCells(geometry, meaning.colour, [&](Cell c) {
      return comparison.isKnown(c) && comparison.verdict(c) == meaning.verdict;
    });
    legend.push_back({meaning.colour, meaning.text});
  }
  drawMarks(input, kPath, canvas);
  canvas.drawFooter("", legend);
  return canvas.png();
}

std::string renderPanels(const EvaluationInput& input, const std::string& truth_note,
                         const std::vector<MapPanel>& maps, bool with_legend) {
  Canvas canvas(shownArea(input), static_cast<int>(maps.size()) + 1);
  canvas.beginPanel(0, "truth", truth_note);
  fillState(input.truth, CellState::kFree, Canvas::kFree, canvas);
  fillState(input.truth, CellState::kOccupied, Canvas::kOccupied, canvas);
  drawMarks(input, kPanelPath, canvas);
  canvas.endPanel();
  int panel = 0;
  for (const MapPanel& shown : maps) {
    canvas.beginPanel(++panel, shown.title, shown.note);
    fillState(shown.map, CellState::kFree, Canvas::kFree, canvas);
    fillState(input.truth, CellState::kOccupied, kTrueWall, canvas);
    fillState(shown.map, CellState::kOccupied, Canvas::kOccupied, canvas);
    canvas.endPanel();
  }
  canvas.drawFooter("", with_legend
                            ? std::vector<LegendEntry>{{Canvas::kFree, "free"},
                                                       {Canvas::kOccupied, "wall"},
                                                       {Canvas::kUnknown, "unknown"},
                                                       {kTrueWall, "true wall, not drawn"},
                                                       {kPanelPath, "path", true},
                                                       {Canvas::kAccessPoint, "access point", true}}
                            : std::vector<LegendEntry>{});
  return canvas.png();
}

}  // namespace sfw
