#include "simulation/building/floor_plan_png.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "files/png.h"
#include "grid/morphology.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

constexpr std::uint8_t kMiddle = 128;

enum class Ground {
  kUnknown,  // transparent pixels are no part of the building
  kFloor     // only walls are drawn, as SVG and CAD programs export them
};

CellState stateOf(std::uint8_t grey, std::uint8_t opacity, Ground ground) {
  if (ground == Ground::kFloor) {
    constexpr int kWhite = 255;
    const int on_white = (grey * opacity + kWhite * (kWhite - opacity)) / kWhite;
    return on_white < kMiddle ? CellState::kOccupied : CellState::kFree;
  }
  if (opacity < kMiddle) {
    return CellState::kUnknown;
  }
  return grey < kMiddle ? CellState::kOccupied : CellState::kFree;
}

Grid<CellState> statesOf(const TranslucentImage& image, double metres_per_pixel, Ground ground) {
  Grid<CellState> states(
      GridGeometry(metres_per_pixel, Position::Zero(), image.grey.width, image.grey.height));
  std::size_t pixel = 0;
  for (std::int64_t y = states.geometry.height() - 1; y >= 0; --y) {  // top row first
    for (std::int64_t x = 0; x < states.geometry.width(); ++x, ++pixel) {
      states[{x, y}] = stateOf(image.grey.pixels[pixel], image.opacity[pixel], ground);
    }
  }
  return states;
}

/// The ground of a picture: floor if its walls enclose more transparent pixels than there are light
/// ones.
Ground groundOf(const Grid<CellState>& states) {
  Mask walls(states.geometry);
  std::size_t light = 0;
  for (std::size_t i = 0; i < walls.cells.size(); ++i) {
    walls.cells[i] = states.cells[i] == CellState::kOccupied ? 1 : 0;
    light += states.cells[i] == CellState::kFree ? 1 : 0;
  }
  const Mask indoors = withHolesFilled(walls);
  std::size_t enclosed = 0;
  for (std::size_t i = 0; i < walls.cells.size(); ++i) {
    enclosed += states.cells[i] == CellState::kUnknown && indoors.cells[i] != 0 ? 1 : 0;
  }
  return enclosed > light ? Ground::kFloor : Ground::kUnknown;
}

/// Whether nothing light is drawn.
bool hasNoLight(const Grid<CellState>& states) {
  return std::find(states.cells.begin(), states.cells.end(), CellState::kFree) ==
         states.cells.end();
}

/// Makes free cells unknown if they are connected with the image border, because they are outside.
void clearAround(const std::string& file, Grid<CellState>& states) {
  Mask built(states.geometry);
  for (std::size_t i = 0; i < built.cells.size(); ++i) {
    built.cells[i] = states.cells[i] == CellState::kFree ? 0 : 1;
  }
  const Mask indoors = withHolesFilled(built);
  bool any_free = false;
  for (std::size_t i = 0; i < built.cells.size(); ++i) {
    if (indoors.cells[i] == 0) {
      states.cells[i] = CellState::kUnknown;
    }
    any_free = any_free || states.cells[i] == CellState::kFree;
  }
  if (!any_free) {
    throw InputError(
        file +
        ": no enclosed room: every white or transparent area touches the image border; close the "
        "outer walls and doors in the image");
  }
}

}  // namespace

Grid<CellState> readFloorPlanPng(const std::string& file, const FloorPlanOptions& options) {
  const TranslucentImage image = readPng(file);
  if (options.metres_per_pixel == 0.0) {
    throw InputError(file + ": a PNG has no scale: give metres per pixel");
  }
  Grid<CellState> states = statesOf(image, options.metres_per_pixel, Ground::kUnknown);
  if (hasNoLight(states) || groundOf(states) == Ground::kFloor) {
    states = statesOf(image, options.metres_per_pixel, Ground::kFloor);
  }
  clearAround(file, states);
  return states;
}

}  // namespace sfw
