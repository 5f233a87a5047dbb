#pragma once

#include <atomic>
#include <vector>

#include "radio/radio_bins.h"
#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// How many rays pass through each cell, from how many access points, and the least loss on any.
struct RayEvidence {
  explicit RayEvidence(const GridGeometry& geometry)
      : rays(geometry), access_points(geometry), least_loss(geometry, kUnseen) {}

  static constexpr float kUnseen = 1e6F;

  Grid<float> rays;
  Grid<float> access_points;
  Grid<float> least_loss;  ///< [dB]; kUnseen where no ray passes
};

/// Follows the ray to each bin.
/// @param losses  on the ray to each bin of each access point [dB]
/// @param stop    polled; when it turns true the result is incomplete
/// O(cells crossed by rays).
RayEvidence rayEvidence(const GridGeometry& geometry, const std::vector<AccessPointBins>& heard,
                        const std::vector<std::vector<double>>& losses,
                        const std::atomic<bool>& stop);

}  // namespace sfw
