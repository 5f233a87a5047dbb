#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// An 8-bit grey image, top row first.
struct GreyImage {
  std::int64_t width = 0;
  std::int64_t height = 0;
  std::vector<std::uint8_t> pixels;
};

/// Reads a PGM (P2 or P5, 8 or 16 bit) and scales its values to 0..255.
/// @throw InputError naming the file if it cannot be read, is cut short or has another format.
GreyImage readPgm(const std::string& file);

/// Encodes `pixel(Cell)` as an 8-bit PGM (P5).
template <class Pixel>
std::string encodePgm(const GridGeometry& geometry, Pixel&& pixel) {
  std::string bytes = "P5\n" + std::to_string(geometry.width()) + " " +
                      std::to_string(geometry.height()) + "\n255\n";
  bytes.reserve(bytes.size() + geometry.size());
  Cell c;
  for (c.y = geometry.height() - 1; c.y >= 0; --c.y) {  // top row first
    for (c.x = 0; c.x < geometry.width(); ++c.x) {
      bytes.push_back(static_cast<char>(pixel(c)));
    }
  }
  return bytes;
}

}  // namespace sfw
