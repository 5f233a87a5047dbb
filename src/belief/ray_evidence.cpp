#include "belief/ray_evidence.h"

#include <algorithm>

#include "grid/ray.h"

namespace sfw {

RayEvidence rayEvidence(const GridGeometry& geometry,
                        const std::vector<AccessPointBins>& access_points,
                        const std::vector<std::vector<double>>& ray_loss_db,
                        const std::atomic<bool>& stop) {
  RayEvidence evidence(geometry);
  Grid<std::size_t> last(geometry, access_points.size());
  for (std::size_t i = 0; i < access_points.size(); ++i) {
    for (std::size_t j = 0; j < access_points[i].bins.size() && !stop; ++j) {
      const auto loss_db = static_cast<float>(ray_loss_db[i][j]);
      Ray(geometry, access_points[i].position, access_points[i].bins[j].position)
          .forEachCell([&](Cell c) {
            if (!geometry.contains(c)) {
              return;
            }
            evidence.rays[c] += 1.0F;
            evidence.least_loss[c] = std::min(evidence.least_loss[c], loss_db);
            if (last[c] != i) {
              last[c] = i;
              evidence.access_points[c] += 1.0F;
            }
          });
    }
  }
  return evidence;
}

}  // namespace sfw
