#include "checks/drive_notes.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "checks/note_text.h"
#include "checks/recording_checks.h"
#include "structure_from_wifi/grid_geometry.h"

namespace sfw {
namespace {

using Notes = std::vector<MapNote>;

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

enum class PathShape { kEmpty, kStanding, kStraight, kWide };

PathShape shapeOf(const std::vector<PathPose>& path) {
  constexpr double kStanding = 0.5;   // [m]
  constexpr double kStraight = 0.15;  // [m]
  if (path.empty()) {
    return PathShape::kEmpty;
  }
  const Eigen::Vector2d spread = spreadOf(path);
  return spread[0] < kStanding   ? PathShape::kStanding
         : spread[1] < kStraight ? PathShape::kStraight
                                 : PathShape::kWide;
}

void addNoteOnPath(PathShape shape, Notes& notes) {
  switch (shape) {
    case PathShape::kEmpty:
      notes.push_back({MapNote::Kind::kTooLittle, "",
                       "no pose is known: the map is empty; check the topics of scans and "
                       "transforms, and the warnings about readings that are left out"});
      break;
    case PathShape::kStanding:
      notes.push_back({MapNote::Kind::kTooLittle, "",
                       "the robot hardly moved, so the map shows little but its position; drive it "
                       "through the building"});
      break;
    case PathShape::kStraight:
      notes.push_back({MapNote::Kind::kTooLittle, "",
                       "the path is straight and contains no information about the area beside it; "
                       "drive through the rooms and along their walls"});
      break;
    case PathShape::kWide:
      break;
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

/// Whether half of the steps are faster than any robot in a building.
bool isTooFast(const PathMotion& motion) {
  constexpr double kTooFast = 5.0;  // [m/s]
  return motion.usual_speed_m_s > kTooFast;
}

void addNoteOnMotion(const PathMotion& motion, Notes& notes) {
  if (isTooFast(motion)) {
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

void addNoteOnOneStamp(std::size_t stamped_alike, Notes& notes) {
  notes.push_back({MapNote::Kind::kStamps, "",
                   "all readings have the same stamp, so the map uses only the strongest one of "
                   "each radio (" +
                       std::to_string(stamped_alike) +
                       " are not used); stamp each scan with the time of its reception, and keep "
                       "all digits: a spreadsheet may save 1600000000 and later as 1.60E+09"});
}

void addNoteOnOctomap(const Snapshot& snapshot, Notes& notes) {
  if (snapshot.offset.isZero() && !octomapReaches(snapshot.belief.geometry())) {
    notes.push_back({MapNote::Kind::kOctomap, "",
                     "there is no OctoMap: the map lies more than 32768 cells from the frame's "
                     "origin; use a frame with a nearer origin, or raise map/resolution"});
  }
}

}  // namespace

void addNotesOnDrive(const Snapshot& snapshot, Notes& notes) {
  const RecordingFindings& recording = snapshot.recording;
  if (recording.is_one_stamp) {
    addNoteOnOneStamp(snapshot.stamped_alike, notes);
  } else if (recording.are_stamps_cut) {
    addNoteOnStamps(snapshot.stamped_alike, notes);
  }
  if (arePosesWrong(recording)) {
    return;
  }
  // The mapper refuses signals that are no dBm with their poses.
  const bool are_poses_refused =
      recording.signal_unit || (snapshot.path.empty() && !recording.sentinels.empty());
  if (!are_poses_refused) {
    addNoteOnPath(shapeOf(snapshot.path), notes);
  }
  addNoteOnStrayPoses(snapshot.stray, notes);
  addNoteOnMotion(snapshot.motion, notes);
  addNoteOnStamps(snapshot.stamped_alike, notes);
  addNoteOnOctomap(snapshot, notes);
}

void addNoteOnGaps(const GapFinding& gaps, Notes& notes) {
  notes.push_back(
      {MapNote::Kind::kCoverage, "",
       counted(gaps.steps, "step", "steps") + " between readings, " +
           std::to_string(std::lround(100.0 * gaps.share)) +
           " % of the way, are longer than path/max_gap (" + roughly(gaps.max_gap_m) +
           " m; half of them are longer than " + rounded(gaps.usual_m, 1) +
           " m), so the way between these readings is not taken as driven; drive slower, "
           "scan more often, or raise path/max_gap if the robot drove straight between "
           "them"});
}

bool isDriven(const std::vector<PathPose>& path) {
  const PathShape shape = shapeOf(path);
  return shape != PathShape::kEmpty && shape != PathShape::kStanding;
}

bool isStraight(const std::vector<PathPose>& path) { return shapeOf(path) == PathShape::kStraight; }

bool isDoubtful(const PathMotion& motion) { return motion.jumps > 0 || isTooFast(motion); }

}  // namespace sfw
