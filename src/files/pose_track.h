#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "files/csv_fields.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// The poses of each robot by time, from a file beside a recording that has none.
class PoseTrack {
 public:
  /// Reads a CSV with the columns stamp, x, y, robot (seconds, metres) in any order of rows.
  /// @throw InputError naming the file and the line of the first unusable row, or if there are
  /// fewer than two poses
  explicit PoseTrack(const std::string& file);

  /// Sets the position of a reading, on the straight line between the poses before and after it.
  /// @return a fault if its robot has no poses, or it is before the first pose, after the last one,
  /// or in a gap: between poses over 5 s apart that are not at one place
  std::optional<RowFault> locate(Reading& reading);

  /// @throw InputError that tells both times if no reading so far lies between the first pose and
  /// the last one
  void requireMeeting(const std::string& readings_file) const;

 private:
  struct Pose {
    std::int64_t stamp_ns;
    Position position;
  };

  std::string file_;
  std::map<std::string, std::vector<Pose>> tracks_;    // of each robot, by stamp
  std::int64_t first_pose_ns_ = 0, last_pose_ns_ = 0;  // of all robots
  std::optional<std::int64_t> first_reading_ns_;
  std::int64_t last_reading_ns_ = 0;
};

}  // namespace sfw
