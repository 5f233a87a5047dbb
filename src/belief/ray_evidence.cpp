#include "belief/ray_evidence.h"

#include <algorithm>

#include "grid/ray.h"

namespace sfw {

RayEvidence rayEvidence(const GridGeometry& geometry, const std::vector<AccessPointBins>& heard,
                        const std::vector<std::vector<double>>& losses,
                        const std::atomic<bool>& stop) {
  RayEvidence evidence(geometry);
  Grid<std::size_t> last(geometry, heard.size());
  for (std::size_t i = 0; i < heard.size(); ++i) {
    for (std::size_t j = 0; j < heard[i].bins.size() && !stop; ++j) {
      const auto loss = static_cast<float>(losses[i][j]);
      Ray(geometry, heard[i].position, heard[i].bins[j].position).forEachCell([&](Cell c) {
        if (!geometry.contains(c)) {
          return;
        }
        evidence.rays[c] += 1.0F;
        evidence.least_loss[c] = std::min(evidence.least_loss[c], loss);
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
