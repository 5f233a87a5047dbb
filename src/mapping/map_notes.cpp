#include "structure_from_wifi/map_notes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "structure_from_wifi/grid_geometry.h"

namespace sfw {
namespace {

using Notes = std::vector<MapNote>;

/// "1 pose is" or "3 poses are".
std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

std::string secondsText(std::int64_t stamp_ns) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << 1e-9 * static_cast<double>(stamp_ns) << " s";
  return text.str();
}

/// Standard deviations of the positions along and across their main direction [m].
Eigen::Vector2d spreadOf(const std::vector<PathPose>& path) {
  const auto count = static_cast<double>(path.size());
  Position mean = Position::Zero();
  for (const PathPose& pose : path) {
    mean += pose.antenna_in_map / count;
  }
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  for (const PathPose& pose : path) {
    const Position away = pose.antenna_in_map - mean;
    covariance += away * away.transpose() / count;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(covariance, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().cwiseMax(0.0).cwiseSqrt().reverse();
}

void addNoteOnPath(const Snapshot& snapshot, Notes& notes) {
  constexpr double kStanding = 0.5;   // [m]
  constexpr double kStraight = 0.15;  // [m]
  if (snapshot.path.empty()) {
    notes.push_back({MapNote::Kind::kTooLittle, "", "no pose is known: the map is empty"});
    return;
  }
  const Eigen::Vector2d spread = spreadOf(snapshot.path);
  if (spread[0] < kStanding) {
    notes.push_back({MapNote::Kind::kTooLittle, "",
                     "the robot hardly moved, so the map shows little but its position; drive it "
                     "through the building"});
  } else if (spread[1] < kStraight) {
    notes.push_back({MapNote::Kind::kTooLittle, "",
                     "the path is straight and contains no information about the area beside it; "
                     "drive through the rooms and along their walls"});
  }
}

void addNoteOnStrayPoses(const StrayPoses& stray, Notes& notes) {
  if (stray.count > 0) {
    notes.push_back({MapNote::Kind::kStrayPoses, "",
                     counted(stray.count, "pose is", "poses are") +
                         " left out with the readings there: up to " +
                         std::to_string(std::lround(stray.farthest_m)) +
                         " m away, farther than the robot can drive in that time; the first one "
                         "is at " +
                         secondsText(stray.first_stamp_ns) +
                         "; check the localisation at that time"});
  }
}

void addNoteOnMotion(const PathMotion& motion, Notes& notes) {
  constexpr double kTooFast = 5.0;  // [m/s], for half of the steps of a robot in a building
  if (motion.usual_speed_m_s > kTooFast) {
    notes.push_back({MapNote::Kind::kMotion, "",
                     "half of the path's steps are faster than " +
                         std::to_string(std::lround(motion.usual_speed_m_s)) +
                         " m/s; check that each pose has its own stamp, in seconds"});
  } else if (motion.jumps > 0) {
    notes.push_back({MapNote::Kind::kMotion, "",
                     "the path jumps " + counted(motion.jumps, "time", "times") + ", by up to " +
                         std::to_string(std::lround(motion.farthest_jump_m)) +
                         " m, and goes on from there; the first jump is at " +
                         secondsText(motion.first_jump_stamp_ns) +
                         "; the parts of the map before and after a jump may be misaligned: check "
                         "the localisation"});
  }
}

void addNoteOnStamps(std::size_t stamped_alike, Notes& notes) {
  if (stamped_alike > 0) {
    notes.push_back({MapNote::Kind::kStamps, "",
                     counted(stamped_alike, "reading is", "readings are") +
                         " not used: the same radio has a stronger reading at the same stamp and "
                         "another position; check whether stamps are rounded, such as to seconds"});
  }
}

/// Whether readings were taken at many places, all at the same time.
bool isOneStamp(const Snapshot& snapshot) {
  return snapshot.stamped_alike > 0 && !snapshot.path.empty() &&
         snapshot.path.front().stamp_ns == snapshot.path.back().stamp_ns;
}

/// Notes on poses and their stamps.
void addNotesOnDrive(const Snapshot& snapshot, Notes& notes) {
  if (isOneStamp(snapshot)) {
    notes.push_back({MapNote::Kind::kStamps, "",
                     "all readings have the same stamp, so the map uses only the strongest one of "
                     "each radio (" +
                         std::to_string(snapshot.stamped_alike) +
                         " are not used); stamp each scan with the time of its reception"});
    return;
  }
  addNoteOnPath(snapshot, notes);
  addNoteOnStrayPoses(snapshot.stray, notes);
  addNoteOnMotion(snapshot.motion, notes);
  addNoteOnStamps(snapshot.stamped_alike, notes);
}

void addNoteOnSignals(const Snapshot& snapshot, Notes& notes) {
  constexpr std::size_t kFewReadings = 50;
  constexpr double kAlike = 0.5;  // [dB], half a step of most radios
  std::size_t all_readings = 0;
  std::size_t readings = 0;
  double deviation_db = 0.0;
  for (const AccessPointSummary& summary : snapshot.access_points) {
    all_readings += summary.readings;
    if (hasPosition(summary)) {
      readings += summary.readings;
      deviation_db = std::max(deviation_db, summary.rssi_deviation_db);
    }
  }
  if (all_readings == 0) {
    notes.push_back(
        {MapNote::Kind::kTooLittle, "",
         "no reading of an access point of the table can be used: the map follows from the path "
         "alone; compare the BSSIDs"});
  } else if (readings == 0) {
    notes.push_back({MapNote::Kind::kTooLittle, "",
                     "no access point with readings has a position: the map follows from the path "
                     "alone; add positions to the table of access points"});
  } else if (isOneStamp(snapshot)) {
    return;  // there are few readings, and another note explains it
  } else if (readings < kFewReadings) {
    notes.push_back({MapNote::Kind::kTooLittle, "",
                     "only " + counted(readings, "reading is", "readings are") +
                         " of access points with a position: too few to find walls; drive on"});
  } else if (deviation_db < kAlike) {
    notes.push_back({MapNote::Kind::kSignals, "",
                     "all signals of an access point are equal and contain no information about "
                     "walls; check that the wireless driver reports RSSI"});
  }
}

/// A few such readings do no harm. A robot may also stand beside a strong access point.
void addNoteOnStrength(const Snapshot& snapshot, Notes& notes) {
  constexpr double kMany = 0.01;  // of all readings
  std::size_t readings = 0;
  std::size_t at_zero = 0;
  for (const AccessPointSummary& summary : snapshot.access_points) {
    readings += summary.readings;
    at_zero += summary.at_zero_dbm;
  }
  if (static_cast<double>(at_zero) > kMany * static_cast<double>(readings)) {
    notes.push_back({MapNote::Kind::kSignals, "strength",
                     counted(at_zero, "reading is", "readings are") +
                         " of 0 dBm, more than any radio receives; leave out the readings that the "
                         "driver reports for inaudible radios"});
  }
}

/// An access point without readings may simply be far away. The note gives its name, so that the
/// user can look for it.
void addNoteOnSilence(const Snapshot& snapshot, Notes& notes) {
  constexpr std::size_t kMostNamed = 5;
  std::string names;
  std::size_t silent = 0;
  for (const AccessPointSummary& summary : snapshot.access_points) {
    if (summary.readings == 0 && ++silent <= kMostNamed) {
      names += (silent > 1 ? ", " : "") + summary.access_point.bssid.str();
    }
  }
  if (silent > 0 && silent < snapshot.access_points.size()) {
    notes.push_back({MapNote::Kind::kTooLittle, "",
                     std::to_string(silent) + " of " +
                         std::to_string(snapshot.access_points.size()) +
                         " access points of the table have no reading: " + names +
                         (silent > kMostNamed ? ", ..." : "")});
  }
}

/// Adds a note on a position that is uncertain or contradicts the readings.
void addNoteOnPosition(const AccessPointSummary& summary, const AccessPointFit* fit, Notes& notes) {
  const std::string name = summary.access_point.bssid.str();
  if (summary.estimate && summary.estimate->ambiguous) {
    notes.push_back(
        {MapNote::Kind::kAccessPoint, name,
         name + " has several likely positions, such as on both sides of a straight path; the "
                "map uses the likeliest one; measure its position, or drive around it"});
  }
  if (fit != nullptr && fit->suspect) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << name << ": its readings fit a position "
         << fit->distance_m << " m away, at (" << fit->estimate.position.x() << ", "
         << fit->estimate.position.y()
         << "), much better than the given one; measure its position again";
    notes.push_back({MapNote::Kind::kAccessPoint, name, text.str()});
  }
}

}  // namespace

bool isFault(const MapNote& note) { return note.kind != MapNote::Kind::kTooLittle; }

std::vector<MapNote> mapNotes(const Snapshot& snapshot, const DataFindings& findings) {
  Notes notes;
  addNotesOnDrive(snapshot, notes);
  addNoteOnSignals(snapshot, notes);
  addNoteOnStrength(snapshot, notes);
  addNoteOnSilence(snapshot, notes);
  for (std::size_t i = 0; i < snapshot.access_points.size(); ++i) {
    addNoteOnPosition(snapshot.access_points[i], findings.fit(i), notes);
  }
  if (!octomapReaches(snapshot.belief.geometry())) {
    notes.push_back({MapNote::Kind::kOctomap, "",
                     "there is no OctoMap: the map lies more than 32768 cells from the frame's "
                     "origin; use a frame with a nearer origin, or raise map/resolution"});
  }
  if (findings.drift && findings.drift->suspect) {
    notes.push_back({MapNote::Kind::kDrift, "",
                     "the path seems to have drifted: where it returns to a place, signals differ "
                     "as much as from room to room; improve the localisation"});
  }
  return notes;
}

}  // namespace sfw
