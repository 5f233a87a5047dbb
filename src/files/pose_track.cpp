#include "files/pose_track.h"

#include <algorithm>

#include "files/text.h"

namespace sfw {
namespace {

constexpr std::int64_t kLongestGapNs = 5'000'000'000;
constexpr double kStands = 0.1;  // [m]; a robot that does so may wait for any time

std::string secondsText(std::int64_t stamp_ns) {
  return formatted("%.3f", 1e-9 * static_cast<double>(stamp_ns));
}

}  // namespace

PoseTrack::PoseTrack(const std::string& file) : file_(file) {
  CsvTable table(file, placeColumns());
  std::size_t count = 0;
  while (table.next()) {
    Pose pose{0, Position::Zero()};
    if (const auto fault = readPlace(table, pose.stamp_ns, pose.position)) {
      throw unusable(table, *fault);
    }
    tracks_[robotOf(table)].push_back(pose);
    first_pose_ns_ = count == 0 ? pose.stamp_ns : std::min(first_pose_ns_, pose.stamp_ns);
    last_pose_ns_ = count == 0 ? pose.stamp_ns : std::max(last_pose_ns_, pose.stamp_ns);
    ++count;
  }
  if (count < 2) {
    throw InputError(file + ": two poses are needed; it has " + std::to_string(count));
  }
  for (auto& [robot, poses] : tracks_) {
    std::stable_sort(poses.begin(), poses.end(),
                     [](const Pose& a, const Pose& b) { return a.stamp_ns < b.stamp_ns; });
  }
}

std::optional<RowFault> PoseTrack::locate(Reading& reading) {
  const std::int64_t stamp_ns = reading.stamp_ns;
  first_reading_ns_ = std::min(first_reading_ns_.value_or(stamp_ns), stamp_ns);
  last_reading_ns_ = std::max(last_reading_ns_, stamp_ns);
  const std::string detail = "stamp " + secondsText(stamp_ns);
  const auto track = tracks_.find(reading.robot);
  if (track == tracks_.end()) {
    return RowFault{"the path has no pose of its robot", "robot '" + reading.robot.str() + "'"};
  }
  const std::vector<Pose>& poses = track->second;
  if (stamp_ns < poses.front().stamp_ns || stamp_ns > poses.back().stamp_ns) {
    return RowFault{"its stamp is before the first pose or after the last one", detail};
  }
  const auto after =
      std::lower_bound(poses.begin(), poses.end(), stamp_ns,
                       [](const Pose& pose, std::int64_t stamp) { return pose.stamp_ns < stamp; });
  if (after->stamp_ns == stamp_ns) {
    reading.antenna_in_map = after->position;
    return std::nullopt;
  }
  const auto before = after - 1;
  const std::int64_t gap_ns = after->stamp_ns - before->stamp_ns;
  const Position way = after->position - before->position;
  if (gap_ns > kLongestGapNs && way.norm() > kStands) {
    return RowFault{"its stamp lies in a gap of over 5 s between poses", detail};
  }
  const double share =
      static_cast<double>(stamp_ns - before->stamp_ns) / static_cast<double>(gap_ns);
  reading.antenna_in_map = before->position + share * way;
  return std::nullopt;
}

void PoseTrack::requireMeeting(const std::string& readings_file) const {
  if (first_reading_ns_ &&
      (*first_reading_ns_ > last_pose_ns_ || last_reading_ns_ < first_pose_ns_)) {
    throw InputError(readings_file + ": its readings are from " + secondsText(*first_reading_ns_) +
                     " to " + secondsText(last_reading_ns_) + " s, but the poses in " + file_ +
                     " from " + secondsText(first_pose_ns_) + " to " + secondsText(last_pose_ns_) +
                     " s; bring both to one clock (times without a zone are read as UTC)");
  }
}

}  // namespace sfw
