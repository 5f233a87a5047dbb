#include "files/png.h"

#include <png.h>

#include <csetjmp>
#include <cstring>
#include <stdexcept>

#include "files/text.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// Decodes a PNG by libpng's transforms. Its simplified interface would convert colours and gamma
/// in linear light, so the thresholds of maps and plans would no longer mean the values in the
/// file.
///
/// libpng leaves through longjmp at an error. So each function that calls setjmp has no object with
/// a destructor.
class PngDecoder {
 public:
  explicit PngDecoder(std::string_view bytes)
      : rest_(bytes),
        png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, keepProblem, ignoreWarning)),
        info_(png_ == nullptr ? nullptr : png_create_info_struct(png_)) {
    if (info_ == nullptr) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw std::runtime_error("libpng cannot be set up");
    }
    png_set_read_fn(png_, this, read);
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // readPng has a limit of its own
  }
  PngDecoder(const PngDecoder&) = delete;
  PngDecoder& operator=(const PngDecoder&) = delete;
  ~PngDecoder() { png_destroy_read_struct(&png_, &info_, nullptr); }

  /// Reads the part before the pixels and asks for 8 bits of grey or RGB, with opacity.
  /// @return false at an error, which problem() tells
  bool readHeader() {
    if (setjmp(png_jmpbuf(png_)) != 0) {
      return false;
    }
    png_read_info(png_, info_);
    png_set_expand(png_);  // palettes, fewer than 8 bits, and transparent colours
    png_set_scale_16(png_);
    png_set_add_alpha(png_, 0xff, PNG_FILLER_AFTER);
    png_set_interlace_handling(png_);
    return true;
  }

  /// Reads the pixels, after readHeader.
  /// @param rows  start of each row in a buffer with channels() bytes a pixel
  /// @return false at an error, which problem() tells
  bool readPixels(png_bytepp rows) {
    if (setjmp(png_jmpbuf(png_)) != 0) {
      return false;
    }
    png_read_image(png_, rows);
    png_read_end(png_, nullptr);
    return true;
  }

  std::int64_t width() const { return png_get_image_width(png_, info_); }
  std::int64_t height() const { return png_get_image_height(png_, info_); }
  std::size_t channels() const {
    const bool coloured = (png_get_color_type(png_, info_) & PNG_COLOR_MASK_COLOR) != 0;
    return coloured ? 4 : 2;
  }
  const std::string& problem() const { return problem_; }

 private:
  [[noreturn]] static void keepProblem(png_structp png, png_const_charp message) {
    static_cast<PngDecoder*>(png_get_error_ptr(png))->problem_ = message;
    png_longjmp(png, 1);
  }

  static void ignoreWarning(png_structp /*png*/, png_const_charp /*message*/) {}

  static void read(png_structp png, png_bytep data, std::size_t length) {
    std::string_view& rest = static_cast<PngDecoder*>(png_get_io_ptr(png))->rest_;
    if (rest.size() < length) {
      png_error(png, "unexpected end of file");
    }
    std::memcpy(data, rest.data(), length);
    rest.remove_prefix(length);
  }

  std::string_view rest_;
  std::string problem_;
  png_structp png_;
  png_infop info_;
};

/// The luma of ITU-R BT.601. A grey colour keeps its value.
std::uint8_t lumaOf(const std::uint8_t* rgb) {
  return static_cast<std::uint8_t>((299 * rgb[0] + 587 * rgb[1] + 114 * rgb[2] + 500) / 1000);
}

std::uint8_t meanOf(const std::uint8_t* rgb) {
  return static_cast<std::uint8_t>((rgb[0] + rgb[1] + rgb[2] + 1) / 3);
}

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

/// @param format  of libpng, for the bytes of a pixel
std::string encoded(std::int64_t width, std::int64_t height, png_uint_32 format,
                    const std::vector<std::uint8_t>& pixels) {
  PngImage png;
  png->width = static_cast<png_uint_32>(width);
  png->height = static_cast<png_uint_32>(height);
  png->format = format;
  png->flags = PNG_IMAGE_FLAG_FAST;  // maps have large areas of one colour: little is lost
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(*png);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(png.get(), bytes.data(), &size, 0, pixels.data(), 0, nullptr) ==
      0) {
    throw std::runtime_error(std::string("the image cannot be encoded as PNG: ") + png->message);
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace

bool isPng(std::string_view bytes) {
  constexpr std::string_view kMagic = "\x89PNG\r\n\x1a\n";
  return bytes.substr(0, kMagic.size()) == kMagic;
}

TranslucentImage readPng(const std::string& file, GreyOf grey) {
  const std::string bytes = readFile(file);
  if (!isPng(bytes)) {
    throw InputError(file + ": not a PNG image; convert it, e.g. with ImageMagick");
  }
  PngDecoder decoder(bytes);
  const auto require = [&](bool ok) {
    if (!ok) {
      throw InputError(file + ": the PNG image is damaged or cut short (" + decoder.problem() +
                       "); save or copy it again");
    }
  };
  require(decoder.readHeader());
  const std::int64_t width = decoder.width();
  const std::int64_t height = decoder.height();
  if (width > kMostPngPixels / height) {
    throw InputError(file + ": the picture must have 1 to " + std::to_string(kMostPngPixels) +
                     " pixels; it has " + std::to_string(width) + " x " + std::to_string(height) +
                     "; scale it down");
  }
  const std::size_t channels = decoder.channels();
  const auto count = static_cast<std::size_t>(width * height);
  std::vector<std::uint8_t> values(channels * count);
  std::vector<png_bytep> rows;
  for (std::int64_t y = 0; y < height; ++y) {
    rows.push_back(values.data() + static_cast<std::size_t>(y * width) * channels);
  }
  require(decoder.readPixels(rows.data()));
  TranslucentImage image{{width, height, std::vector<std::uint8_t>(count)},
                         std::vector<std::uint8_t>(count)};
  const auto grey_of = grey == GreyOf::kMean ? meanOf : lumaOf;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* const pixel = &values[channels * i];
    image.grey.pixels[i] = channels == 4 ? grey_of(pixel) : pixel[0];
    image.opacity[i] = pixel[channels - 1];
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
  return encoded(image.grey.width, image.grey.height, PNG_FORMAT_GA, pairs);
}

std::string encodeRgbPng(std::int64_t width, std::int64_t height,
                         const std::vector<std::uint8_t>& rgb) {
  return encoded(width, height, PNG_FORMAT_RGB, rgb);
}

}  // namespace sfw
