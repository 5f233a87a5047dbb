#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "simulation/building/floor_plan.h"

namespace sfw {

/// What a building is used for, which decides its layout.
enum class BuildingKind { kFlat, kOffice };

/// @param name  "flat" or "office"
/// @throw InputError naming the text and both kinds.
BuildingKind parseBuildingKind(std::string_view name);

/// What to build.
struct PlanGeneratorConfig {
  BuildingKind kind = BuildingKind::kFlat;
  double area_m2 = 90.0;       ///< of floor and interior walls, 30..400 [m2]
  double resolution_m = 0.05;  ///< 0.01..0.1, as walls are 0.1 m and more [m]
  double rotation_rad = 0.0;   ///< of the building about the map frame's origin
  std::uint64_t seed = 1;      ///< decides all the rest
};

/// Every problem of a configuration, one sentence each that starts with the setting's name.
std::vector<std::string> validate(const PlanGeneratorConfig& config);

/// What a room is for.
enum class RoomKind {
  kLiving,
  kKitchen,
  kBedroom,
  kStudy,
  kBath,
  kToilet,
  kStorage,  // of flats, but offices too
  kCorridor,
  kOffice,
  kOpenPlan,
  kMeeting
};

/// "living room", "bedroom", ...
std::string toText(RoomKind kind);

/// A rectangle of floor. An L-shaped corridor consists of two.
struct GeneratedRoom {
  RoomKind kind = RoomKind::kLiving;
  Position centre = Position::Zero();  ///< [m], map frame
  Position size = Position::Zero();    ///< along the building's own axes [m]
};

/// A building and what its rooms are for.
struct GeneratedPlan {
  FloorPlan plan;
  std::vector<GeneratedRoom> rooms;
};

/// Builds a flat or an office floor as they are built: rooms on one or both sides of a corridor, in
/// one wing, two wings at a right angle, or around a core; interior walls of 0.1 to 0.2 m, outer
/// walls of 0.25 to 0.35 m, doors of 0.8 to 0.9 m standing open, wide openings to living rooms and
/// open-plan offices, the entrance shut. A robot of 0.25 m radius gets into every room.
///
/// The layout is drawn in whole centimetres by integer arithmetic alone: one seed gives one
/// building on every machine, up to the last bit of sine and cosine if it is rotated.
/// @throw InputError naming every setting out of range.
/// O(cells x rooms).
GeneratedPlan generatePlan(const PlanGeneratorConfig& config);

}  // namespace sfw
