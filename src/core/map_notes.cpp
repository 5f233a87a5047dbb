#include "structure_from_wifi/map_notes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "structure_from_wifi/octomap_export.h"

namespace sfw {
namespace {

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

void addNoteOnPath(const Snapshot& snapshot, std::vector<std::string>& notes) {
  constexpr double kStanding = 0.5;   // [m]
  constexpr double kStraight = 0.15;  // [m]
  if (snapshot.path.empty()) {
    notes.emplace_back("no pose is known: the map is empty");
    return;
  }
  const Eigen::Vector2d spread = spreadOf(snapshot.path);
  if (spread[0] < kStanding) {
    notes.emplace_back(
        "the robot hardly moved: the map shows little but its place; drive it through the "
        "building");
  } else if (spread[1] < kStraight) {
    notes.emplace_back(
        "the path is straight: it does not tell what lies beside it; drive through the rooms, and "
        "along their walls");
  }
}

void addNoteOnStrayPoses(const StrayPoses& stray, std::vector<std::string>& notes) {
  if (stray.count == 0) {
    return;
  }
  std::ostringstream text;
  text << stray.count << (stray.count == 1 ? " pose is" : " poses are")
       << " left out, with all that was heard there: up to " << std::lround(stray.farthest_m)
       << " m away, the robot would have had to jump there and back; the first one at "
       << std::fixed << std::setprecision(3) << 1e-9 * static_cast<double>(stray.first_stamp_ns)
       << " s; look at what its localisation did";
  notes.push_back(text.str());
}

void addNoteOnJumps(const PathJumps& jumps, std::vector<std::string>& notes) {
  if (jumps.count == 0) {
    return;
  }
  std::ostringstream text;
  text << "the path jumps " << jumps.count << (jumps.count == 1 ? " time" : " times")
       << " and stays there, by up to " << std::lround(jumps.farthest_m) << " m, first at "
       << std::fixed << std::setprecision(3) << 1e-9 * static_cast<double>(jumps.first_stamp_ns)
       << " s: what it says before and after fits together only if both places are right";
  notes.push_back(text.str());
}

/// Whether readings were taken at many places, all at the same time.
bool isOneStamp(const Snapshot& snapshot) {
  return snapshot.stamped_alike > 0 && !snapshot.path.empty() &&
         snapshot.path.front().stamp_ns == snapshot.path.back().stamp_ns;
}

void addNoteOnStamps(std::size_t stamped_alike, std::vector<std::string>& notes) {
  if (stamped_alike > 0) {
    notes.push_back(std::to_string(stamped_alike) +
                    (stamped_alike == 1 ? " reading counts" : " readings count") +
                    " for nothing: the same radio was heard stronger at the same stamp, but at "
                    "another place; look whether stamps are cut, as to whole seconds");
  }
}

void addNoteOnSignals(const Snapshot& snapshot, std::vector<std::string>& notes) {
  constexpr std::size_t kFewReadings = 50;
  constexpr double kAlike = 0.5;  // [dB], half a step of most radios
  std::size_t readings = 0;
  double deviation_db = 0.0;
  for (const AccessPointSummary& summary : snapshot.access_points) {
    if (isPlaced(summary)) {
      readings += summary.readings;
      deviation_db = std::max(deviation_db, summary.rssi_deviation_db);
    }
  }
  if (readings == 0) {
    notes.emplace_back(
        "no access point that was heard has a place: the map shows what the path alone tells; list "
        "access points with their positions");
  } else if (readings < kFewReadings) {
    notes.push_back("only " + std::to_string(readings) +
                    (readings == 1 ? " reading is" : " readings are") +
                    " of access points with a place: too few to tell of walls");
  } else if (deviation_db < kAlike) {
    notes.emplace_back(
        "all signals of an access point are alike: they tell nothing of walls; look whether the "
        "wireless driver reports RSSI");
  }
}

/// Of several that are heard, one may just be far away; a name says which to look for.
void addNoteOnSilence(const Snapshot& snapshot, std::vector<std::string>& notes) {
  constexpr std::size_t kMostNamed = 5;
  std::string names;
  std::size_t silent = 0;
  for (const AccessPointSummary& summary : snapshot.access_points) {
    if (summary.readings == 0 && ++silent <= kMostNamed) {
      names += (silent > 1 ? ", " : "") + summary.access_point.bssid.str();
    }
  }
  if (silent > 0 && silent < snapshot.access_points.size()) {
    notes.push_back(std::to_string(silent) + " of " +
                    std::to_string(snapshot.access_points.size()) +
                    " access points of the table were never heard: " + names +
                    (silent > kMostNamed ? ", ..." : ""));
  }
}

/// Of access points that are mapped with at one of several places where they may stand.
void addNoteOnGuesses(const Snapshot& snapshot, std::vector<std::string>& notes) {
  for (const AccessPointSummary& summary : snapshot.access_points) {
    if (summary.estimate && summary.estimate->ambiguous) {
      notes.push_back(summary.access_point.bssid.str() +
                      " may stand at several places, as on either side of a straight way: the map "
                      "reckons with the likeliest; measure its position, or drive around it");
    }
  }
}

}  // namespace

std::vector<std::string> mapNotes(const Snapshot& snapshot) {
  std::vector<std::string> notes;
  if (isOneStamp(snapshot)) {
    notes.push_back("all readings bear one stamp, of each radio only the strongest counts (" +
                    std::to_string(snapshot.stamped_alike) +
                    " do not): give each scan the time when it was made");
  } else {
    addNoteOnPath(snapshot, notes);
    addNoteOnStrayPoses(snapshot.stray, notes);
    addNoteOnJumps(snapshot.jumps, notes);
    addNoteOnStamps(snapshot.stamped_alike, notes);
    addNoteOnSignals(snapshot, notes);
  }
  addNoteOnGuesses(snapshot, notes);
  addNoteOnSilence(snapshot, notes);
  if (!octomapReaches(snapshot.belief.geometry())) {
    notes.emplace_back(
        "there is no OctoMap: it ends 32768 cells from the frame's origin, and this map lies "
        "beyond; "
        "use a frame that begins nearer, or larger cells (map/resolution)");
  }
  if (snapshot.drift && snapshot.drift->suspect) {
    notes.emplace_back(
        "the path looks as if it drifted: where it comes back to a place, signals differ as they "
        "do from room to room");
  }
  return notes;
}

}  // namespace sfw
