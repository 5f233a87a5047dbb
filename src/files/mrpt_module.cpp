// The library structure_from_wifi_mrpt: all code of this package that needs MRPT's libraries.
// mrptFunctions() loads it.

#include <mrpt/img/CImage.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>
#include <exception>
#include <stdexcept>

#include "files/mrpt_library.h"
#include "structure_from_wifi/export.h"

namespace sfw {
namespace {

using MrptGrid = mrpt::maps::COccupancyGridMap2D;

std::shared_ptr<const MrptGrid> toGrid(const Box& box, double resolution_m, std::int64_t width,
                                       std::int64_t height,
                                       const std::vector<std::int8_t>& log_odds) {
  auto grid = std::make_shared<MrptGrid>(
      static_cast<float>(box.min().x()), static_cast<float>(box.max().x()),
      static_cast<float>(box.min().y()), static_cast<float>(box.max().y()),
      static_cast<float>(resolution_m));
  // MRPT calculates the size from extents in float. It must equal our size.
  if (grid->getSizeX() != width || grid->getSizeY() != height) {
    throw std::invalid_argument("geometry is too large or too far from the origin for MRPT");
  }
  for (std::int64_t y = 0; y < height; ++y) {
    std::copy_n(log_odds.begin() + static_cast<std::ptrdiff_t>(y * width), width,
                grid->getRow(static_cast<int>(y)));
  }
  return grid;
}

TranslucentImage readImage(const std::string& file) {
  constexpr unsigned kChannels = 3;
  constexpr int kColour = 1;  // 8 bits for each channel
  mrpt::img::CImage picture;
  TranslucentImage image;
  try {
    if (!picture.loadFromFile(file, kColour)) {
      return image;
    }
  } catch (const std::exception&) {  // OpenCV's error is the same for damage and other formats
    return image;
  }
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
}  // namespace sfw

extern "C" SFW_EXPORT const sfw::MrptFunctions sfw_mrpt_functions;
const sfw::MrptFunctions sfw_mrpt_functions{sfw::toGrid, sfw::readImage};
