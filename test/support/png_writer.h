#pragma once

#include <png.h>

#include <cstdint>
#include <string>
#include <vector>

namespace sfw::test {

/// What a PNG holds, in libpng's terms.
struct PngContent {
  int colour_type = PNG_COLOR_TYPE_GRAY;
  int depth = 8;                                ///< [bit] of each channel
  std::vector<std::vector<std::uint8_t>> rows;  ///< packed as in the file; top row first
  std::vector<png_color> palette = {};
  std::vector<std::uint8_t> palette_opacity = {};
  bool black_is_transparent = false;  ///< of grey or RGB images
  double gamma = 0.0;                 ///< of the gAMA chunk; 0: none
  bool interlaced = false;
};

/// Encodes an image as it is, without any conversion.
/// @param height  in the header. If it is not the number of rows, the file ends where pixels begin.
inline std::string encoded(const PngContent& content, std::uint32_t width, std::uint32_t height) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &bytes,
      [](png_structp to, png_bytep data, std::size_t length) {
        static_cast<std::string*>(png_get_io_ptr(to))
            ->append(reinterpret_cast<const char*>(data), length);
      },
      nullptr);
  png_set_IHDR(png, info, width, height, content.depth, content.colour_type,
               content.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (!content.palette.empty()) {
    png_set_PLTE(png, info, content.palette.data(), static_cast<int>(content.palette.size()));
  }
  const png_color_16 black{};
  if (content.black_is_transparent || !content.palette_opacity.empty()) {
    png_set_tRNS(png, info, content.palette_opacity.data(),
                 static_cast<int>(content.palette_opacity.size()), &black);
  }
  if (content.gamma > 0.0) {
    png_set_gAMA(png, info, content.gamma);
  }
  png_write_info(png, info);
  if (content.rows.size() == height) {
    std::vector<png_bytep> rows;
    for (const std::vector<std::uint8_t>& row : content.rows) {
      rows.push_back(const_cast<png_bytep>(row.data()));
    }
    png_write_image(png, rows.data());
    png_write_end(png, info);
  } else {
    bytes += std::string("\0\0\0\0IDAT", 8);
  }
  png_destroy_write_struct(&png, &info);
  return bytes;
}

}  // namespace sfw::test
