#include "simulation/building/floor_plan_io.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/validation.h"
#include "files/map_server.h"
#include "files/png.h"
#include "files/text.h"
#include "grid/morphology.h"
#include "grid/outline_fill.h"
#include "simulation/building/floor_plan_png.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

constexpr double kWallThickness = 0.15;  // around a HouseExpo outline, which has none there [m]
constexpr double kWidestSlit = 0.6;      // between rooms; wider gaps are no wall [m]
constexpr double kMargin = 0.5;          // [m]
constexpr std::int64_t kMostCells = 64'000'000;
constexpr std::int64_t kMostCrossings = kMostCells;  // keeps memory in the same bounds

enum class PlanKind { kHouseExpo, kMapServer, kPicture };

PlanKind kindOf(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".yaml" || ending == ".yml") {
    return PlanKind::kMapServer;
  }
  const std::string bytes = readFile(file);
  if (ending == ".png" || isPng(bytes)) {
    return PlanKind::kPicture;
  }
  const std::string_view text = trimmed(bytes);
  if (ending == ".json" || (!text.empty() && text.front() == '{')) {
    return PlanKind::kHouseExpo;
  }
  throw InputError(file +
                   ": not a plan: give a HouseExpo .json, a map_server .yaml (for a .pgm, the one "
                   "beside it) or a .png");
}

Position parseVertex(const nlohmann::json& vertex, const std::string& name) {
  constexpr double kFar = 1e6;  // metres; no building reaches farther
  if (!vertex.is_array() || vertex.size() != 2 || !vertex[0].is_number() ||
      !vertex[1].is_number()) {
    throw InputError(name + " must be a pair of numbers");
  }
  Position position(vertex[0].get<double>(), vertex[1].get<double>());
  if (!(position.array().abs() <= kFar).all()) {
    throw InputError(name + " must lie within 1000 km of the origin");
  }
  return position;
}

std::vector<Position> parseOutline(const std::string& file) {
  const nlohmann::json json = nlohmann::json::parse(readFile(file), nullptr, false);
  if (json.is_discarded()) {
    throw InputError(file + ": not valid JSON");
  }
  if (!json.is_object() || !json.contains("verts") || !json["verts"].is_array()) {
    throw InputError(file + ": not a HouseExpo plan: 'verts', a list of [x, y], is missing");
  }
  std::vector<Position> outline;
  for (const nlohmann::json& vertex : json["verts"]) {
    outline.push_back(
        parseVertex(vertex, file + ": 'verts': vertex " + std::to_string(outline.size() + 1)));
  }
  if (outline.size() < 3) {
    throw InputError(file + ": 'verts' has " + std::to_string(outline.size()) +
                     " vertices; an outline needs three");
  }
  return outline;
}

/// @throw InputError if the outline is so long that its crossings would not fit memory.
void requireTraceable(const std::string& file, const std::vector<Position>& outline,
                      double resolution) {
  double crossings = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    crossings += (outline[(i + 1) % outline.size()] - outline[i]).lpNorm<1>() / resolution;
  }
  if (crossings > static_cast<double>(kMostCrossings)) {
    throw InputError(file + ": the outline is too intricate for this resolution");
  }
}

/// Adds walls around and between the free cells. Thin walls exist already.
void buildWalls(Grid<CellState>& states) {
  const double resolution = states.geometry.resolution();
  Mask free(states.geometry);
  for (std::size_t i = 0; i < free.cells.size(); ++i) {
    free.cells[i] = states.cells[i] == CellState::kFree ? 1 : 0;
  }
  // At coarse resolutions a wall is still one cell.
  const Mask around = dilated(free, std::max(std::sqrt(2.0), kWallThickness / resolution));
  const Mask between = closed(free, 0.5 * kWidestSlit / resolution);
  for (std::size_t i = 0; i < free.cells.size(); ++i) {
    if (free.cells[i] == 0 && (around.cells[i] != 0 || between.cells[i] != 0)) {
      states.cells[i] = CellState::kOccupied;
    }
  }
}

Grid<CellState> readHouseExpo(const std::string& file, const FloorPlanOptions& options) {
  const std::vector<Position> outline = parseOutline(file);
  requireTraceable(file, outline, options.resolution_m);
  Box box;
  for (const Position& vertex : outline) {
    box.extend(vertex);
  }
  const double margin = kMargin + options.resolution_m;
  const Box grid_box(box.min().array() - margin, box.max().array() + margin);
  try {
    Grid<CellState> states = fillOutline(
        outline,
        GridGeometry::covering(grid_box, options.resolution_m, options.resolution_m, kMostCells));
    buildWalls(states);
    return states;
  } catch (const std::invalid_argument&) {
    throw InputError(file +
                     ": the plan would have more than 64 million cells; choose a coarser "
                     "resolution");
  }
}

Grid<CellState> readStates(const std::string& file, const FloorPlanOptions& options) {
  switch (kindOf(file)) {
    case PlanKind::kHouseExpo:
      return readHouseExpo(file, options);
    case PlanKind::kMapServer:
      return readMap(file);
    case PlanKind::kPicture:
      break;
  }
  return readFloorPlanPng(file, options);
}

}  // namespace

std::vector<std::string> validate(const FloorPlanOptions& options) {
  constexpr double kLeast = 0.001, kMost = 10.0;  // [m]
  Problems problems;
  problems.within("resolution", options.resolution_m, kLeast, kMost, "m");
  if (options.metres_per_pixel != 0.0) {
    problems.within("metres_per_pixel", options.metres_per_pixel, kLeast, kMost, "m");
  }
  return problems.list();
}

FloorPlan readFloorPlan(const std::string& file, const FloorPlanOptions& options) {
  throwIfAny(validate(options));
  const Grid<CellState> states = readStates(file, options);
  if (static_cast<std::int64_t>(states.cells.size()) > kMostCells) {
    throw InputError(file + ": the plan has more than 64 million cells");
  }
  if (std::find(states.cells.begin(), states.cells.end(), CellState::kFree) == states.cells.end()) {
    throw InputError(file + ": the plan has no free cell");
  }
  return withMaterials(states);
}

}  // namespace sfw
