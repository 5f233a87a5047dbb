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
                     "the robot hardly moved: the map shows little but its place; drive it through "
                     "the building"});
  } else if (spread[1] < kStraight) {
    notes.push_back({MapNote::Kind::kTooLittle, "",
                     "the path is straight: it does not tell what lies beside it; drive through "
                     "the rooms, and along their walls"});
  }
}

void addNoteOnStrayPoses(const StrayPoses& stray, Notes& notes) {
  if (stray.count > 0) {
    notes.push_back({MapNote::Kind::kStrayPoses, "",
                     counted(stray.count, "pose is", "poses are") +
                         " left out, with all that was heard there: up to " +
                         std::to_string(std::lround(stray.farthest_m)) +
                         " m away, where the robot cannot have got so fast; the first one at " +
                         secondsText(stray.first_stamp_ns) +
                         "; look at what its localisation did"});
  }
}

void addNoteOnMotion(const PathMotion& motion, Notes& notes) {
  constexpr double kTooFast = 5.0;  // [m/s], for half of the steps of a robot in a building
  if (motion.usual_speed_m_s > kTooFast) {
    notes.push_back({MapNote::Kind::kMotion, "",
                     "half of the path's steps are faster than " +
                         std::to_string(std::lround(motion.usual_speed_m_s)) +
                         " m/s: look whether each pose has its own stamp, in seconds"});
  } else if (motion.jumps > 0) {
    notes.push_back({MapNote::Kind::kMotion, "",
                     "the path jumps " + counted(motion.jumps, "time", "times") +
                         " and stays there, by up to " +
                         std::to_string(std::lround(motion.farthest_jump_m)) + " m, first at " +
                         secondsText(motion.first_jump_stamp_ns) +
                         ": what it says before and after fits together only if both places are "
                         "right"});
  }
}

void addNoteOnStamps(std::size_t stamped_alike, Notes& notes) {
  if (stamped_alike > 0) {
    notes.push_back({MapNote::Kind::kStamps, "",
                     counted(stamped_alike, "reading counts", "readings count") +
                         " for nothing: the same radio was heard stronger at the same stamp, but "
                         "at another place; look whether stamps are cut, as to whole seconds"});
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
                     "all readings bear one stamp, of each radio only the strongest counts (" +
                         std::to_string(snapshot.stamped_alike) +
                         " do not): give each scan the time when it was made"});
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
  std::size_t heard = 0;
  std::size_t readings = 0;
  double deviation_db = 0.0;
  for (const AccessPointSummary& summary : snapshot.access_points) {
    heard += summary.readings;
    if (hasPosition(summary)) {
      readings += summary.readings;
      deviation_db = std::max(deviation_db, summary.rssi_deviation_db);
    }
  }
  if (heard == 0) {
    notes.push_back(
        {MapNote::Kind::kTooLittle, "",
         "no reading of an access point of the table can be used: the map shows at most what "
         "the path alone tells"});
  } else if (readings == 0) {
    notes.push_back({MapNote::Kind::kTooLittle, "",
                     "no access point that was heard has a place: the map shows what the path "
                     "alone tells; list access points with their positions"});
  } else if (isOneStamp(snapshot)) {
    return;  // there are few readings, and it is told why
  } else if (readings < kFewReadings) {
    notes.push_back({MapNote::Kind::kTooLittle, "",
                     "only " + counted(readings, "reading is", "readings are") +
                         " of access points with a place: too few to tell of walls"});
  } else if (deviation_db < kAlike) {
    notes.push_back({MapNote::Kind::kSignals, "",
                     "all signals of an access point are alike: they tell nothing of walls; look "
                     "whether the wireless driver reports RSSI"});
  }
}

/// A few such readings do no harm; and a robot may stand beside a strong access point.
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
                         " of 0 dBm, stronger than radios are heard: leave out what a driver says "
                         "of radios that it does not hear"});
  }
}

/// Of several that are heard, one may just be far away; a name says which to look for.
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
                         " access points of the table were never heard: " + names +
                         (silent > kMostNamed ? ", ..." : "")});
  }
}

/// On a place that is a guess, or not where the table has it.
void addNoteOnPlace(const AccessPointSummary& summary, const AccessPointFit* fit, Notes& notes) {
  const std::string name = summary.access_point.bssid.str();
  if (summary.estimate && summary.estimate->ambiguous) {
    notes.push_back({MapNote::Kind::kAccessPoint, name,
                     name +
                         " may stand at several places, as on either side of a straight way: the "
                         "map reckons with the likeliest; measure its position, or drive around "
                         "it"});
  }
  if (fit != nullptr && fit->suspect) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << name << ": its readings fit a place "
         << fit->distance_m << " m away, at (" << fit->estimate.position.x() << ", "
         << fit->estimate.position.y() << "), much better than the one given";
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
    addNoteOnPlace(snapshot.access_points[i], findings.fit(i), notes);
  }
  if (!octomapReaches(snapshot.belief.geometry())) {
    notes.push_back({MapNote::Kind::kOctomap, "",
                     "there is no OctoMap: it ends 32768 cells from the frame's origin, and this "
                     "map lies beyond; use a frame that begins nearer, or larger cells "
                     "(map/resolution)"});
  }
  if (findings.drift && findings.drift->suspect) {
    notes.push_back({MapNote::Kind::kDrift, "",
                     "the path looks as if it drifted: where it comes back to a place, signals "
                     "differ as they do from room to room"});
  }
  return notes;
}

}  // namespace sfw
