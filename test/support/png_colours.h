#pragma once

#include <cairo.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <map>
#include <string>

namespace sfw::test {

/// How many pixels of each colour (0xRRGGBB) a PNG has.
inline std::map<std::uint32_t, int> coloursOf(const std::string& png) {
  struct Source {
    const std::string& bytes;
    std::size_t at;
  } source{png, 0};
  const auto read = [](void* closure, unsigned char* data, unsigned int length) {
    auto* from = static_cast<Source*>(closure);
    if (from->bytes.size() - from->at < length) {
      return CAIRO_STATUS_READ_ERROR;
    }
    std::memcpy(data, from->bytes.data() + from->at, length);
    from->at += length;
    return CAIRO_STATUS_SUCCESS;
  };
  cairo_surface_t* surface = cairo_image_surface_create_from_png_stream(read, &source);
  EXPECT_EQ(cairo_surface_status(surface), CAIRO_STATUS_SUCCESS);
  std::map<std::uint32_t, int> colours;
  const unsigned char* row = cairo_image_surface_get_data(surface);
  for (int y = 0; y < cairo_image_surface_get_height(surface); ++y) {
    for (int x = 0; x < cairo_image_surface_get_width(surface); ++x) {
      std::uint32_t pixel = 0;
      std::memcpy(&pixel, row + 4 * x, 4);
      ++colours[pixel & 0xffffff];
    }
    row += cairo_image_surface_get_stride(surface);
  }
  cairo_surface_destroy(surface);
  return colours;
}

}  // namespace sfw::test
