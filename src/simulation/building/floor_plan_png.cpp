#include "simulation/building/floor_plan_png.h"

#include <cairo.h>

#include <cstring>
#include <memory>

#include "files/text.h"
#include "grid/morphology.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

struct Destroy {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Surface = std::unique_ptr<cairo_surface_t, Destroy>;

cairo_status_t readBytes(void* rest, unsigned char* data, unsigned int length) {
  auto& bytes = *static_cast<std::string_view*>(rest);
  if (bytes.size() < length) {
    return CAIRO_STATUS_READ_ERROR;
  }
  std::memcpy(data, bytes.data(), length);
  bytes.remove_prefix(length);
  return CAIRO_STATUS_SUCCESS;
}

/// The big-endian number at a byte of a PNG's header.
std::int64_t headerNumber(std::string_view bytes, std::size_t at) {
  std::int64_t value = 0;
  for (std::size_t i = at; i < at + 4; ++i) {
    value = value * 256 + static_cast<unsigned char>(bytes[i]);
  }
  return value;
}

/// @throw InputError before any allocation for the pixels.
void requireFits(const std::string& file, std::string_view bytes, std::int64_t max_cells) {
  constexpr std::size_t kWidthAt = 16;
  constexpr std::size_t kHeightAt = 20;
  if (!isPng(bytes) || bytes.size() < kHeightAt + 4) {
    throw InputError(file + ": not a PNG image");
  }
  const std::int64_t width = headerNumber(bytes, kWidthAt);
  const std::int64_t height = headerNumber(bytes, kHeightAt);
  if (width == 0 || height == 0 || width > max_cells / height) {
    throw InputError(file + ": the picture must have 1 to " + std::to_string(max_cells) +
                     " pixels; it has " + std::to_string(width) + " x " + std::to_string(height));
  }
}

/// The picture with 8 bits a channel, for any depth of the file.
Surface decode(const std::string& file, std::int64_t max_cells) {
  const std::string bytes = readFile(file);
  requireFits(file, bytes, max_cells);
  std::string_view rest = bytes;
  const Surface picture(cairo_image_surface_create_from_png_stream(readBytes, &rest));
  if (cairo_surface_status(picture.get()) != CAIRO_STATUS_SUCCESS) {
    throw InputError(file + ": the PNG image is damaged or cut short");
  }
  Surface pixels(cairo_image_surface_create(CAIRO_FORMAT_ARGB32,
                                            cairo_image_surface_get_width(picture.get()),
                                            cairo_image_surface_get_height(picture.get())));
  const std::unique_ptr<cairo_t, Destroy> context(cairo_create(pixels.get()));
  cairo_set_source_surface(context.get(), picture.get(), 0.0, 0.0);
  cairo_set_operator(context.get(), CAIRO_OPERATOR_SOURCE);
  cairo_paint(context.get());
  if (cairo_status(context.get()) != CAIRO_STATUS_SUCCESS) {
    throw InputError(file + ": the picture does not fit memory");
  }
  cairo_surface_flush(pixels.get());
  return pixels;
}

/// The state of the cell that one premultiplied ARGB pixel draws.
CellState stateOf(std::uint32_t pixel) {
  const auto channel = [pixel](unsigned shift) {
    return static_cast<double>((pixel >> shift) & 0xffu) / 255.0;
  };
  const double alpha = channel(24);
  if (alpha < 0.5) {
    return CellState::kUnknown;
  }
  // Luma of ITU-R BT.601.
  const double light = (0.299 * channel(16) + 0.587 * channel(8) + 0.114 * channel(0)) / alpha;
  return 1.0 - light > 0.5 ? CellState::kOccupied : CellState::kFree;
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

bool isPng(std::string_view bytes) {
  constexpr std::string_view kMagic = "\x89PNG\r\n\x1a\n";
  return bytes.substr(0, kMagic.size()) == kMagic;
}

Grid<CellState> readFloorPlanPng(const std::string& file, const FloorPlanOptions& options,
                                 std::int64_t max_cells) {
  const Surface pixels = decode(file, max_cells);
  if (options.metres_per_pixel == 0.0) {
    throw InputError(file + ": a PNG has no scale: give metres per pixel");
  }
  Grid<CellState> states(GridGeometry(options.metres_per_pixel, Position::Zero(),
                                      cairo_image_surface_get_width(pixels.get()),
                                      cairo_image_surface_get_height(pixels.get())));
  const unsigned char* row = cairo_image_surface_get_data(pixels.get());
  for (std::int64_t y = states.geometry.height() - 1; y >= 0; --y) {
    for (std::int64_t x = 0; x < states.geometry.width(); ++x) {
      std::uint32_t pixel = 0;
      std::memcpy(&pixel, row + x * 4, sizeof pixel);
      states[{x, y}] = stateOf(pixel);
    }
    row += cairo_image_surface_get_stride(pixels.get());
  }
  clearAround(file, states);
  return states;
}

}  // namespace sfw
