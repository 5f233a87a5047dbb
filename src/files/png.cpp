#include "files/png.h"

#include <png.h>

#include <stdexcept>

#include "files/text.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// libpng's image of 8-bit grey values and opacity. It is freed at the end.
class PngImage {
 public:
  PngImage() { image_.version = PNG_IMAGE_VERSION; }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;
  ~PngImage() { png_image_free(&image_); }

  png_image& operator*() { return image_; }
  png_image* operator->() { return &image_; }
  png_image* get() { return &image_; }

 private:
  png_image image_{};
};

}  // namespace

TranslucentImage readPng(const std::string& file) {
  const std::string bytes = readFile(file);
  PngImage png;
  const auto fail = [&] {
    throw InputError(file + ": not a whole PNG image (" + png->message + ")");
  };
  if (png_image_begin_read_from_memory(png.get(), bytes.data(), bytes.size()) == 0) {
    fail();
  }
  constexpr png_uint_32 kMaxSide = 1U << 18;
  constexpr std::size_t kMaxPixels = std::size_t{1} << 26;
  const std::size_t count = std::size_t{png->width} * png->height;
  if (png->width > kMaxSide || png->height > kMaxSide || count > kMaxPixels) {
    throw InputError(file + ": the image is too large; scale it down");
  }
  png->format = PNG_FORMAT_GA;
  std::vector<std::uint8_t> pairs(2 * count);
  if (png_image_finish_read(png.get(), nullptr, pairs.data(), 0, nullptr) == 0) {
    fail();
  }
  TranslucentImage image{{png->width, png->height, {}}, {}};
  for (std::size_t i = 0; i < count; ++i) {
    image.grey.pixels.push_back(pairs[2 * i]);
    image.opacity.push_back(pairs[2 * i + 1]);
  }
  return image;
}

std::string encodePng(const TranslucentImage& image) {
  std::vector<std::uint8_t> pairs;
  pairs.reserve(2 * image.grey.pixels.size());
  for (std::size_t i = 0; i < image.grey.pixels.size(); ++i) {
    pairs.push_back(image.grey.pixels[i]);
    pairs.push_back(image.opacity[i]);
  }
  PngImage png;
  png->width = static_cast<png_uint_32>(image.grey.width);
  png->height = static_cast<png_uint_32>(image.grey.height);
  png->format = PNG_FORMAT_GA;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(*png);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(png.get(), bytes.data(), &size, 0, pairs.data(), 0, nullptr) == 0) {
    throw std::runtime_error(std::string("the image cannot be encoded as PNG: ") + png->message);
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace sfw
