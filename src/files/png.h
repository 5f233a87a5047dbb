#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "files/pgm.h"
#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// An 8-bit grey image with opacity, top row first.
struct TranslucentImage {
  GreyImage grey;
  std::vector<std::uint8_t> opacity;  ///< of each pixel: 0 is transparent, 255 opaque
};

/// Reads a PNG and converts it to grey values. An image without opacity is opaque.
/// @throw InputError naming the file if it cannot be read, is cut short or has another format.
TranslucentImage readPng(const std::string& file);

/// Encodes an image as PNG with 8-bit grey values and opacity.
std::string encodePng(const TranslucentImage& image);

/// Encodes `pixel(Cell)`, an optional grey value, as PNG. Cells without a value are transparent;
/// programs that ignore the opacity see the grey value 128 there.
template <class Pixel>
std::string encodeTransparentPng(const GridGeometry& geometry, Pixel&& pixel) {
  TranslucentImage image{{geometry.width(), geometry.height(), {}}, {}};
  image.grey.pixels.reserve(geometry.size());
  image.opacity.reserve(geometry.size());
  constexpr std::uint8_t kGrey = 128;
  Cell c;
  for (c.y = geometry.height() - 1; c.y >= 0; --c.y) {  // top row first
    for (c.x = 0; c.x < geometry.width(); ++c.x) {
      const std::optional<std::uint8_t> value = pixel(c);
      image.grey.pixels.push_back(value.value_or(kGrey));
      image.opacity.push_back(value ? 255 : 0);
    }
  }
  return encodePng(image);
}

}  // namespace sfw
