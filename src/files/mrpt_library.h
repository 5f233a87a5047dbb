#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "files/png.h"
#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/types.h"

namespace mrpt::maps {
class COccupancyGridMap2D;
}

namespace sfw {

/// What this package uses of MRPT's libraries.
struct MrptFunctions {
  /// Makes MRPT's grid.
  /// @param log_odds  of each cell of being free, in MRPT's steps; row-major from the lowest y
  /// @throw std::invalid_argument if MRPT cannot hold the geometry
  std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> (*toGrid)(
      const Box& box, double resolution_m, std::int64_t width, std::int64_t height,
      const std::vector<std::int8_t>& log_odds);

  /// Reads BMP, JPEG, TIFF, PPM and what else OpenCV can.
  /// @return no image if the file is damaged or has another format
  TranslucentImage (*readImage)(const std::string& file);

  /// Predicts signals by CWirelessPowerGridMap2D with the kernel method DM+V.
  /// @param known    samples, not empty
  /// @param sigma_m  of the kernel
  /// @return predicted signals [dBm], one for each position
  std::vector<double> (*predictSignals)(const std::vector<Sample>& known,
                                        const std::vector<Position>& positions, double sigma_m);
};

/// Loads libstructure_from_wifi_mrpt.so at the first call.
///
/// MRPT needs some 150 other libraries. Loading them takes longer than mapping a small home, and
/// hardly any run needs them.
/// @throw std::runtime_error telling what to do if the library cannot be loaded
/// Thread-safe.
const MrptFunctions& mrptFunctions();

}  // namespace sfw
