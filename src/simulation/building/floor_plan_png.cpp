#include "simulation/building/floor_plan_png.h"

#include <cstddef>
#include <cstdint>

#include "files/png.h"
#include "grid/morphology.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

CellState stateOf(std::uint8_t grey, std::uint8_t opacity) {
  constexpr std::uint8_t kMiddle = 128;
  if (opacity < kMiddle) {
    return CellState::kUnknown;
  }
  return grey < kMiddle ? CellState::kOccupied : CellState::kFree;
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
        ": no enclosed room: every white area touches the image border; close the outer "
        "walls and doors in the image");
  }
}

}  // namespace

Grid<CellState> readFloorPlanPng(const std::string& file, const FloorPlanOptions& options) {
  const TranslucentImage image = readPng(file);
  if (options.metres_per_pixel == 0.0) {
    throw InputError(file + ": a PNG has no scale: give metres per pixel");
  }
  Grid<CellState> states(GridGeometry(options.metres_per_pixel, Position::Zero(), image.grey.width,
                                      image.grey.height));
  std::size_t pixel = 0;
  for (std::int64_t y = states.geometry.height() - 1; y >= 0; --y) {  // top row first
    for (std::int64_t x = 0; x < states.geometry.width(); ++x, ++pixel) {
      states[{x, y}] = stateOf(image.grey.pixels[pixel], image.opacity[pixel]);
    }
  }
  clearAround(file, states);
  return states;
}

}  // namespace sfw
