// The library structure_from_wifi_mrpt: all code of this package that needs MRPT's libraries.
// mrptFunctions() loads it.

#include <mrpt/img/CImage.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CWirelessPowerGridMap2D.h>

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

std::vector<double> predictSignals(const std::vector<Sample>& known,
                                   const std::vector<Position>& positions, double sigma_m) {
  using SignalGrid = mrpt::maps::CWirelessPowerGridMap2D;
  constexpr double kCellM = 0.25;
  constexpr double kMarginM = 1.0;
  constexpr double kCutoffSigmas = 4.0;
  Box box;
  for (const Sample& sample : known) {
    box.extend(sample.antenna_in_map);
  }
  for (const Position& position : positions) {
    box.extend(position);
  }
  const Position low = box.min() - Position(kMarginM, kMarginM);
  const Position high = box.max() + Position(kMarginM, kMarginM);
  SignalGrid map(SignalGrid::mrKernelDMV, low.x(), high.x(), low.y(), high.y(), kCellM);
  map.setMinLoggingLevel(mrpt::system::LVL_ERROR);
  map.insertionOptions.sigma = static_cast<float>(sigma_m);
  map.insertionOptions.cutoffRadius = static_cast<float>(kCutoffSigmas * sigma_m);
  for (const Sample& sample : known) {
    map.insertIndividualReading(sample.rssi_dbm,
                                {sample.antenna_in_map.x(), sample.antenna_in_map.y()});
  }
  std::vector<double> predicted_dbm;
  for (const Position& position : positions) {
    double rssi_dbm = 0.0;
    double variance = 0.0;
    map.predictMeasurement(position.x(), position.y(), rssi_dbm, variance, false,
                           SignalGrid::gimBilinear);
    predicted_dbm.push_back(rssi_dbm);
  }
  return predicted_dbm;
}

}  // namespace
}  // namespace sfw

extern "C" SFW_EXPORT const sfw::MrptFunctions sfw_mrpt_functions;
const sfw::MrptFunctions sfw_mrpt_functions{sfw::toGrid, sfw::readImage, sfw::predictSignals};
