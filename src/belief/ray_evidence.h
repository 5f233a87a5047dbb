#pragma once

#include <atomic>
#include <vector>

#include "radio/radio_bins.h"
#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// For each cell the number of rays through it, the number of their access points, and their least
/// loss.
struct RayEvidence {
  explicit RayEvidence(const GridGeometry& geometry)
      : rays(geometry), access_points(geometry), least_loss(geometry, kUnseen) {}

  static constexpr float kUnseen = 1e6F;

  Grid<float> rays;
  Grid<float> access_points;
  Grid<float> least_loss;  ///< [dB]; kUnseen where no ray passes
};

/// Follows the ray from each access point to each of its bins.
/// @param ray_loss_db  on the ray to each bin of each access point
/// @param stop    polled; when it turns true the result is incomplete
/// O(cells crossed by rays).
RayEvidence rayEvidence(const GridGeometry& geometry,
                        const std::vector<AccessPointBins>& access_points,
                        const std::vector<std::vector<double>>& ray_loss_db,
                        const std::atomic<bool>& stop);

}  // namespace sfw
