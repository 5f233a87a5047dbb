#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "structure_from_wifi/config.h"
#include "training/training_drive.h"
#include "walls/channels.h"

namespace sfw {

/// How a drive for the training of the wall network is driven.
enum class WallDriveKind { kAlongWalls, kPatrol, kStroll, kSurvey };

/// A simulated drive for the training of the wall network.
struct WallDrive {
  WallDriveKind kind = WallDriveKind::kAlongWalls;
  std::string noise;  ///< name of the noise level
  TrainingDrive drive;
};

/// The name of a kind: "along_walls", "patrol", "stroll" or "survey".
const char* nameOf(WallDriveKind kind);

/// Draws a kind: one drive in five is a survey, and along walls is the most frequent style.
WallDriveKind chooseWallDriveKind(std::int64_t seed);

/// Simulates a drive for the training of the wall network (doc/method/network.md).
///
/// Radio and errors vary as in makeTrainingDrive. Some drives are surveys, with up to 40 access
/// points, and some are as `sfw simulate` makes them.
/// @return nothing if the drive fits nowhere in the building or is very short.
/// Deterministic.
std::optional<WallDrive> makeWallDrive(const FloorPlan& plan, WallDriveKind kind,
                                       std::int64_t seed);

/// What the wall network sees of a drive, and what it shall learn: rasters in the building frame,
/// on cells of kNetworkCellM, row 0 at the lowest y. The first channels are those of networkInputs,
/// with radio. These follow:
///
/// - `footprint`: 1 in cells that the robot covered,
/// - `free`, `wall`: shares of the cell that a lidar on the path sees as free and as occupied,
/// - `true_walls`: 1 in cells of walls and furniture, seen or not; pieces below 1 m are left out.
/// @throw as extractDriveFeatures
Channels wallRasters(const WallDrive& drive, Config config);

/// Names of the channels of wallRasters after those of networkInputs, in order.
std::vector<std::string> wallLabelNames();

}  // namespace sfw
