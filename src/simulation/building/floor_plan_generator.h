#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "simulation/building/floor_plan.h"

namespace sfw {

/// The use of a building, which decides its layout.
enum class BuildingKind { kFlat, kOffice };

/// @param name  "flat" or "office"
/// @throw InputError naming the text and both kinds.
BuildingKind parseBuildingKind(std::string_view name);

/// A building to generate.
struct BuildingConfig {
  BuildingKind kind = BuildingKind::kFlat;
  double area_m2 = 90.0;       ///< of floor and interior walls, 30..400 [m2]
  double resolution_m = 0.05;  ///< 0.01..0.1, as walls are 0.1 m and more [m]
  double rotation_rad = 0.0;   ///< of the building about the map frame's origin
  std::uint64_t seed = 1;      ///< of the layout
};

/// Every problem of a configuration, one sentence each that starts with the setting's name.
std::vector<std::string> validate(const BuildingConfig& config);

/// Generates the floor plan of a flat or an office floor.
///
/// Rooms lie on one or both sides of a corridor, in one wing, in two wings at a right angle, or
/// around a core. Interior walls are 0.1 to 0.2 m thick, outer walls 0.25 to 0.35 m. Doors of 0.8
/// to 0.9 m are open. Living rooms and open-plan offices have wide openings. The entrance is shut.
/// A robot of 0.25 m radius gets into every room.
///
/// The layout is drawn in whole centimetres by integer arithmetic alone. So one seed gives one
/// building on every machine, up to the last bit of sine and cosine if the building is rotated.
/// @throw InputError naming every setting out of range.
/// O(cells x rooms).
FloorPlan generateFloorPlan(const BuildingConfig& config);

}  // namespace sfw
