#include "simulation/building/building_source.h"

#include "structure_from_wifi/input_error.h"

namespace sfw {

FloorPlan makeFloorPlan(const BuildingSource& source, std::int64_t seed) {
  if (source.plan.empty() == source.generate.empty()) {
    throw InputError(
        "the building needs either a plan (--plan) or a kind to generate (--generate), not both");
  }
  if (source.generate.empty()) {
    return readFloorPlan(source.plan, source.options);
  }
  BuildingConfig config;
  config.kind = parseBuildingKind(source.generate);
  config.area_m2 = source.area_m2;
  config.resolution_m = source.options.resolution_m;
  config.seed = static_cast<std::uint64_t>(seed);
  return generateFloorPlan(config);
}

}  // namespace sfw
