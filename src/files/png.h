#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "files/pgm.h"
#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// An 8-bit grey image with opacity, top row first.
struct TranslucentImage {
  GreyImage grey;
  std::vector<std::uint8_t> opacity;  ///< of each pixel: 0 is transparent, 255 opaque
};

/// How a colour becomes grey.
enum class GreyOf {
  kLuma,  ///< of ITU-R BT.601, as bright as people see it
  kMean   ///< of red, green and blue, as map_server takes it
};

/// Larger images are refused. Decoding takes at most 6 bytes a pixel.
constexpr std::int64_t kMostPngPixels = 64'000'000;

/// Whether bytes begin with the signature of a PNG.
bool isPng(std::string_view bytes);

/// Reads a PNG of any colour type, depth and interlacing.
///
/// Colours become grey, and 16 bits are scaled to 8. A gAMA chunk is ignored,
/// as map_server does. An image without opacity is opaque.
/// @throw InputError naming the file and a remedy if it cannot be read, has another format, is
/// damaged or cut short, or has more than kMostPngPixels pixels. The size is checked before any
/// allocation for the pixels.
TranslucentImage readPng(const std::string& file, GreyOf grey = GreyOf::kLuma);

/// Encodes an image as PNG with 8-bit grey values and opacity.
std::string encodePng(const TranslucentImage& image);

/// Encodes an opaque picture as PNG.
/// @param rgb  three bytes for each pixel, top row first
std::string encodeRgbPng(std::int64_t width, std::int64_t height,
                         const std::vector<std::uint8_t>& rgb);

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
