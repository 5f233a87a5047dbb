#pragma once

#include <atomic>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "access_points/access_point_estimation.h"
#include "belief/belief_model.h"
#include "k_visibility/sparse_inverse.h"
#include "k_visibility/wall_count_model.h"
#include "path/building_frame.h"
#include "path/path.h"
#include "radio/drift.h"
#include "structure_from_wifi/belief_map.h"
#include "structure_from_wifi/config.h"
#include "structure_from_wifi/export.h"
#include "structure_from_wifi/path_correction.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// What became of a reading, pose or contact.
enum class InsertResult {
  kAccepted,
  kPositionNotFinite,
  kPositionTooFar,  ///< the map would pass map/max_cells
  kRssiNotFinite,
  kRssiOutOfRange,      ///< not in (-120, 0] dBm; positive values are often percent
  kUnknownAccessPoint,  ///< not in the table: kept, but only its pose counts, as path
  kTooManyReadings,     ///< map/max_readings
};

/// A short name for counters and messages.
SFW_EXPORT const char* toString(InsertResult insertion);

/// What the readings of one access point came to.
struct AccessPointSummary {
  AccessPoint access_point;
  std::size_t readings = 0;
  std::optional<WallCountModel> model;  ///< of method k_visibility

  /// Where it seems to stand, if the table does not say; access_point has the same position then.
  /// With neither, it could not be placed, and its readings count as path alone.
  std::optional<AccessPointEstimate> estimate = {};

  /// How well its readings fit the table's position, once a Judge looked at it.
  std::optional<AccessPointFit> fit = {};

  double rssi_deviation_db = 0.0;  ///< standard deviation of its readings

  /// Readings of 0 dBm, stronger than radios are heard: some drivers say so of those that are not.
  std::size_t at_zero_dbm = 0;
};

/// Whether an access point has a position, given or estimated.
inline bool hasPosition(const AccessPointSummary& summary) {
  return summary.access_point.position_known || summary.estimate;
}

/// What tomography found beside the belief.
struct TomographySummary {
  Grid<float> wall_loss;  ///< of signals through each cell, by radio alone [dB]
  BuildingFrame frame;
  StyleShares style{};     ///< how far the model for each driving style was used
  double explained = 0.0;  ///< share of what distance leaves of the signals that walls explain
};

/// What was given to a mapper and left out of the map.
struct Rejections {
  std::map<InsertResult, std::size_t> count;
  std::map<Bssid, std::size_t> unknown_access_points;    ///< readings of each; the first 1000 heard
  std::map<std::string, std::size_t> not_inserted = {};  ///< by reason (Mapper::recordRejected)
};

/// Poses at which the robot cannot have been, since it would have had to jump there and back. They
/// count for nothing, nor does what was heard or touched there.
struct StrayPoses {
  std::size_t count = 0;
  std::int64_t first_stamp_ns = 0;
  double farthest_m = 0.0;  ///< from the believed pose before it, or after it if there is none
};

/// How a path goes: at what speed, and where it goes on from another place than it was at.
struct PathMotion {
  double usual_speed_m_s = 0.0;          ///< median of the steps
  std::size_t jumps = 0;                 ///< steps that the robot cannot have driven
  std::int64_t first_jump_stamp_ns = 0;  ///< of the pose after it
  double farthest_jump_m = 0.0;
};

/// A map with all that went into it. Immutable, shared between threads.
struct Snapshot {
  BeliefMap belief;
  std::vector<PathPose> path;                     ///< in the order driven, without stray poses
  std::vector<AccessPointSummary> access_points;  ///< in the order of the table
  Rejections rejections;
  std::optional<TomographySummary> tomography = {};  ///< of method tomography
  std::optional<DriftCheck> drift = {};              ///< once a Judge looked for it
  StrayPoses stray = {};                             ///< left out of all of this
  PathMotion motion = {};                            ///< on the path

  /// Readings that count for nothing since the same radio was heard stronger at the same stamp, but
  /// at another place: stamps were cut.
  std::size_t stamped_alike = 0;
};

/// From readings to the map: collects, then infers everything at once.
///
/// Of a scan that comes twice or names a radio twice, the strongest reading counts.
/// The map is a function of the set of readings: order of arrival, repetition of a scan and the
/// play rate of a bag do not matter. Positions are rounded to 0.1 mm and signals to 0.01 dB on
/// the way in, so neither does the arithmetic by which a pose was computed.
/// Not thread-safe; its owner serialises calls.
class SFW_EXPORT Mapper {
 public:
  /// @throw InputError if the configuration or the table of access points cannot be used.
  Mapper(const Config& config, const std::vector<AccessPoint>& access_points);

  /// O(log access points), but for the first one that seems to be too far after some that were not:
  /// O(readings log readings). Anything but kAccepted and kUnknownAccessPoint leaves the map as it
  /// was.
  InsertResult insert(const Reading& reading);
  InsertResult insert(const Contact& contact);

  /// Notes readings that could not even be inserted, for the report.
  /// @param reason  what was wrong with them, in words
  void recordRejected(const std::string& reason, std::size_t count) {
    rejections_.not_inserted[reason] += count;
  }

  /// Moves all readings and contacts as a localisation corrected the past. What the map cannot
  /// hold there is left out and counted. O(readings log fixes).
  void correct(const PathCorrection& correction);

  /// What the map reaches over without its margin: access points, path and contacts, and what it
  /// once had to hold. O(readings log readings), as all that follows.
  Box extent() const;

  /// Lets the map reach over a box, whatever becomes of readings; one that is too large changes
  /// nothing.
  void growTo(const Box& extent);

  /// Forgets readings, path and contacts; the geometry stays.
  void reset();

  /// The grid that the next snapshot will have. Grows in steps, and shrinks only when poses turn
  /// out to be stray.
  GridGeometry geometry() const;

  /// Everything kept, once, by stamp and bssid: what a file needs to make the same map again.
  std::vector<Reading> readings() const;

  /// Every contact kept, in order of arrival.
  const std::vector<Contact>& contacts() const { return contacts_; }

  const Rejections& rejections() const { return rejections_; }

  /// The map of everything inserted so far.
  /// @param stop polled while inferring; nullptr is returned once it is true
  std::shared_ptr<const Snapshot> infer(const std::atomic<bool>& stop) const;
  std::shared_ptr<const Snapshot> infer() const;

  /// The map without any signal strength: a control that tells what the radio adds.
  std::shared_ptr<const Snapshot> inferWithoutRadio() const;

  /// What was heard of each access point of the table, in the order of stamps.
  std::vector<std::vector<Sample>> samples() const;

 private:
  enum class UseRadio { kSignals, kNothing };

  /// What is heard of one access point: poses in order and signal strengths beside them.
  struct Series {
    std::vector<PathPose> poses;
    std::vector<double> rssi_dbm;
  };

  /// What of everything kept can be true.
  struct Inliers {
    std::vector<PathPose> path;
    std::vector<Reading> readings;
    std::vector<Contact> contacts;
    StrayPoses stray;
    std::size_t stamped_alike = 0;
  };
  Inliers believed() const;

  /// Everything kept, by stamp and bssid, of one stamp the strongest first.
  std::vector<Reading> sorted() const;
  Box extentOf(const Inliers& believed) const;
  GridGeometry geometryOf(const Box& extent) const;

  InsertResult examined(const Reading& reading) const;
  InsertResult accept(const Reading& reading);

  /// Lets the map reach over a point, unless it would be too large.
  InsertResult makeRoomFor(const Position& point);
  bool fits(const Box& extent) const;

  std::shared_ptr<const Snapshot> infer(UseRadio hearing, const std::atomic<bool>& stop) const;
  /// The table with positions estimated where it has none; what cannot be placed is not heard.
  std::vector<AccessPointSummary> placed(std::vector<Series>& heard,
                                         const std::atomic<bool>& stop) const;
  static std::vector<Sample> samplesOf(const Series& series);

  void inferByCounts(std::vector<Series>& heard, UseRadio hearing,
                     const std::vector<Contact>& contacts, const std::atomic<bool>& stop,
                     Snapshot& snapshot) const;
  void inferByTomography(std::vector<Series>& heard, UseRadio hearing,
                         const std::vector<Contact>& contacts, const std::atomic<bool>& stop,
                         Snapshot& snapshot) const;

  std::vector<Series> seriesOf(const std::vector<Reading>& readings) const;  // by access point
  std::vector<double> filtered(const Series& series, const Position& access_point) const;
  WallCountModel fitted(const std::vector<double>& rssi_dbm) const;

  Config config_;
  BeliefModel model_;
  std::vector<AccessPoint> access_points_;
  std::map<Bssid, std::size_t> index_of_;
  Box least_extent_;  // that the map has without any reading
  Box extent_;        // of all that was kept, stray or not, as far as it is needed to refuse more
  std::size_t kept_when_believed_ = 0;  // when it was cut down to what is believed
  std::vector<Reading> readings_;
  std::vector<Contact> contacts_;
  Rejections rejections_;
};

}  // namespace sfw
