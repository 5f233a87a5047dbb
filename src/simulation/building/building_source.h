#pragma once

#include <cstdint>
#include <string>

#include "simulation/building/floor_plan.h"
#include "simulation/building/floor_plan_generator.h"
#include "simulation/building/floor_plan_io.h"

namespace sfw {

/// The source of a known building: a file, or the generator.
struct BuildingSource {
  std::string plan;      ///< a file as readFloorPlan reads it; empty: generate
  std::string generate;  ///< "flat" or "office"; empty: read the file
  FloorPlanOptions options;
  double area_m2 = BuildingConfig().area_m2;  ///< of a generated building
};

/// Reads or generates the building.
/// @param seed  of a generated building, whose cells have the resolution of the options
/// @throw InputError unless exactly one of plan and generate is set, or as readFloorPlan and
/// generateFloorPlan.
FloorPlan makeFloorPlan(const BuildingSource& source, std::int64_t seed);

}  // namespace sfw
