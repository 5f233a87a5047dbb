#pragma once

#include "simulation/building/floor_plan_generator.h"

namespace sfw {

/// The generated office floor that benchmarks measure in.
inline FloorPlan officeFloor(double area_m2 = 400.0) {
  BuildingConfig building;
  building.kind = BuildingKind::kOffice;
  building.area_m2 = area_m2;
  return generateFloorPlan(building);
}

}  // namespace sfw
