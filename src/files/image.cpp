#include "files/image.h"

#include <mrpt/img/CImage.h>

#include "files/pgm.h"
#include "files/text.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

constexpr unsigned kChannels = 3;

/// Reads BMP, JPEG, TIFF, PPM and what else OpenCV can.
TranslucentImage readByOpenCv(const std::string& file) {
  const std::string advice =
      "; convert it to PNG, such as with ImageMagick: convert " + file + " map.png";
  mrpt::img::CImage picture;
  constexpr int kColour = 1;  // 8 bits for each channel
  bool is_read = false;
  try {
    is_read = picture.loadFromFile(file, kColour);
  } catch (const std::exception&) {  // OpenCV's error is the same for damage and other formats
  }
  if (!is_read) {
    throw InputError(file + ": the image is damaged, or its format is not known" + advice);
  }
  TranslucentImage image;
  image.grey.width = static_cast<std::int64_t>(picture.getWidth());
  image.grey.height = static_cast<std::int64_t>(picture.getHeight());
  for (unsigned row = 0; row < picture.getHeight(); ++row) {
    for (unsigned column = 0; column < picture.getWidth(); ++column) {
      unsigned sum = 0;
      for (unsigned channel = 0; channel < kChannels; ++channel) {
        sum += picture.at<std::uint8_t>(column, row, channel);
      }
      image.grey.pixels.push_back(static_cast<std::uint8_t>((sum + 1) / kChannels));
    }
  }
  return image;
}

}  // namespace

TranslucentImage readImage(const std::string& file) {
  const std::string bytes = readFile(file);
  if (isPng(bytes)) {
    return readPng(file, GreyOf::kMean);
  }
  const std::string magic = bytes.substr(0, 2);
  if (magic == "P2" || magic == "P5") {
    return {readPgm(file), {}};
  }
  return readByOpenCv(file);
}

}  // namespace sfw
