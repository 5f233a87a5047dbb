#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "structure_from_wifi/access_point_estimate.h"
#include "structure_from_wifi/belief_map.h"
#include "structure_from_wifi/export.h"
#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/recording_findings.h"
#include "structure_from_wifi/types.h"
#include "structure_from_wifi/wall_segment.h"

namespace sfw {

/// The outcome of inserting a reading or a contact into a mapper.
enum class InsertResult {
  kAccepted,
  kPositionNotFinite,
  kPositionTooFar,  ///< the map would have more than map/max_cells cells
  kRssiNotFinite,
  kRssiOutOfRange,      ///< not in (-120, 0] dBm; positive values are often percent
  kUnknownAccessPoint,  ///< not in the table: the mapper keeps its pose as part of the path
  kTooManyReadings,     ///< the mapper holds map/max_readings already
};

/// Names an outcome in a few words, for counters and messages.
SFW_EXPORT const char* toString(InsertResult result);

/// Counts the readings and contacts that a map does not use.
struct Rejections {
  std::map<InsertResult, std::size_t> count;                 ///< by the mapper's reason
  std::map<Bssid, std::size_t> unknown_access_points;        ///< readings of each, 1000 at most
  std::map<std::string, std::size_t> before_insertion = {};  ///< by Mapper::recordRejected's reason
};

/// Groups of signal strengths, one for each wall count, as method k_visibility finds them.
struct WallCountClusters {
  std::vector<double> centroids_dbm;   ///< C_0 > ... > C_K; empty without readings
  std::vector<double> thresholds_dbm;  ///< t_1 > ... > t_K, the means of neighbouring centroids

  /// The largest wall count K.
  std::size_t walls() const { return thresholds_dbm.size(); }
};

/// An access point of the table and a summary of its readings.
struct AccessPointSummary {
  AccessPoint access_point;                      ///< as in the table
  std::size_t readings = 0;                      ///< number of its readings that the map uses
  std::optional<WallCountClusters> wall_counts;  ///< only of method k_visibility

  /// The estimated position if the table gives none, or only with a standard deviation;
  /// access_point.position has the same value then.
  /// Without any position, the readings of the access point only add poses to the path.
  std::optional<AccessPointEstimate> estimate = {};

  /// The position of the table [m], if the estimate replaces it in access_point.position.
  std::optional<Position> given_position = {};

  double rssi_deviation_db = 0.0;  ///< standard deviation of its readings

  /// The BSSID that stands for its radio, if that is another one. Its readings are joined with
  /// those of that one, and it has the position of that one.
  std::optional<Bssid> radio = {};

  /// Number of its readings that were offered to the mapper, used or not.
  std::size_t heard = 0;

  std::vector<Sample> samples = {};  ///< its readings in the order of stamps, without stray poses
};

/// Whether an access point has a position, given or estimated.
inline bool hasPosition(const AccessPointSummary& summary) {
  return summary.access_point.position_known || summary.estimate;
}

/// The largest standard deviation of an estimated position that tells where signals come from [m].
/// With a larger one, the rays to the readings pass through other rooms than the signals.
constexpr double kUsefulDeviationM = 3.0;

/// Whether a map uses the readings of an access point: its position is given as exact, or the
/// standard deviations of the estimate are at most kUsefulDeviationM.
inline bool isPlaced(const AccessPointSummary& summary) {
  return summary.estimate ? summary.estimate->covariance.diagonal().maxCoeff() <=
                                kUsefulDeviationM * kUsefulDeviationM
                          : summary.access_point.position_known;
}

/// Share of the belief model's expert for each driving style; the shares sum to 1.
struct DrivingStyleShares {
  double along_walls = 0.0;  ///< the robot follows the walls
  double patrol = 0.0;       ///< the robot visits rooms one after another
  double stroll = 0.0;       ///< a person steers, without a plan
};

/// The results of method tomography beside the belief.
struct TomographySummary {
  /// The source of the building's direction.
  enum class YawSource {
    kHeadings,  ///< the robot drives mostly along two directions at right angles
    kSpread,    ///< the long side of the driven area
    kNone       ///< neither is clear: the axes of the map
  };

  Grid<float> wall_loss;          ///< of a signal through each cell [dB], from the radio alone
  double building_yaw_rad = 0.0;  ///< of the building's x axis in the map frame
  YawSource yaw_source = YawSource::kNone;  ///< source of that direction
  DrivingStyleShares style = {};            ///< of the belief model
  double explained_variance = 0.0;  ///< share of the signals' variance around the log-distance law
};

/// Stray poses. The robot cannot have reached them without a jump there and back. A map uses no
/// reading and no contact from such a pose.
struct StrayPoses {
  std::size_t count = 0;            ///< of poses
  std::int64_t first_stamp_ns = 0;  ///< of the first one
  double farthest_m = 0.0;  ///< from the last pose before it that is not stray, or the first after
};

/// The speed of a path, and the jumps after which it continues at the new place.
struct PathMotion {
  double usual_speed_m_s = 0.0;          ///< median of the steps
  std::size_t jumps = 0;                 ///< steps that the robot cannot have driven
  std::int64_t first_jump_stamp_ns = 0;  ///< of the pose after the first jump
  double farthest_jump_m = 0.0;          ///< length of the longest jump
};

/// A map and the data that it was made from. Immutable; threads share it.
struct Snapshot {
  BeliefMap belief;  ///< the map, whose cells are decided: free, occupied or unknown

  /// Probability of each cell before this decision. It is calibrated on simulated drives. A cell is
  /// probably free, ahead of the robot, if it is known here, below 0.5, and not free in the map.
  BeliefMap probability;

  std::vector<PathPose> path;  ///< robot by robot in the order driven, without stray poses
  std::vector<AccessPointSummary> access_points;     ///< in the order of the table
  Rejections rejections;                             ///< data that the map does not use
  std::optional<TomographySummary> tomography = {};  ///< only of method tomography
  StrayPoses stray = {};                             ///< poses that the map does not use
  PathMotion motion = {};                            ///< speed and jumps of the path

  /// Readings without effect: the same radio has a stronger reading at the same stamp and at
  /// another position. They show that stamps were rounded.
  std::size_t stamped_alike = 0;

  Box extent = {};  ///< of access points, path and contacts, without the map's margin [m]

  /// Walls beside the way of the robot. The map shows those between two passes as occupied cells;
  /// cells of outer walls stay unknown. Only method tomography with `belief/walls: network` finds
  /// walls.
  std::vector<WallSegment> walls = {};

  /// Whether a table of access points was given. Without one, access_points are all BSSIDs that
  /// were heard, by address.
  bool has_table = true;

  RecordingFindings recording = {};  ///< what is wrong with the recording

  std::vector<Contact> contacts = {};  ///< in the order of arrival, without those driven over later

  /// By how much the map was moved after it was made [m]. All positions here include it.
  Position offset = Position::Zero();
};

}  // namespace sfw
