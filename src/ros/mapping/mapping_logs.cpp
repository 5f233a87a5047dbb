// What the mapping nodelet logs: each thing once.

#include <cmath>
#include <cstdio>

#include "base/failure.h"
#include "ros/mapping/mapping_nodelet.h"
#include "ros/mapping/other_publishers.h"

namespace sfw {
namespace {

constexpr double kPatience = 10.0;  // [s] without input, before a warning

/// Names a position or an extent in metres.
std::string pairText(const char* format, double a, double b) {
  char text[96];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

/// What to do about readings without a transform. If tf has transforms of other times, the frames
/// have the right names.
const char* adviceOn(const std::string& tf_error) {
  return tf_error.find("extrapolation") != std::string::npos
             ? "compare the clocks of the machines, and look whether the localisation goes on"
             : "start the localisation, or correct ros/antenna_frame and ros/map_frame";
}

}  // namespace

void MappingNodelet::warnOfOtherMappers() {
  const std::string topic = getNodeHandle().resolveName("map");
  std::string others;
  for (const std::string& node :
       otherPublishers(topic, publishers_ ? Advertised::kYes : Advertised::kNo)) {
    others += (others.empty() ? "" : ", ") + node;
  }
  if (!others.empty() && announcements_.isNews("other mappers", others)) {
    NODELET_WARN_STREAM(topic << " is published by " << others
                              << " too, and each map replaces the other one; stop one of them, or "
                                 "give each robot a namespace");
  }
}

void MappingNodelet::announceStart() {
  std::size_t unplaced = 0;
  for (const AccessPoint& access_point : access_points_) {
    unplaced += access_point.position_known ? 0 : 1;
  }
  std::string topics;
  for (const InputStatistics::Input& input : statistics_.inputs(0.0)) {
    topics += input.is_radio ? (topics.empty() ? "" : " or ") + input.topic : "";
  }
  const std::string radios =
      access_points_.empty()
          ? "all access points that are heard, as no table gives any (access_points)"
          : std::to_string(access_points_.size()) + " access points of the table, " +
                std::to_string(unplaced) + " of them without a position";
  NODELET_INFO_STREAM("Mapping with " << radios << ". Waiting for "
                                      << "readings on " << topics << " and for the transform from "
                                      << antennaFramesText(ros_settings_) << " to "
                                      << ros_settings_.map_frame);
}

void MappingNodelet::announceFirstReading(const LocatedObservation& observation) {
  if (announcements_.isNews("first reading")) {
    const Reading& reading = observation.readings.front();
    NODELET_INFO_STREAM("The first reading, of "
                        << reading.bssid.str() << ", is located at "
                        << pairText("(%.2f, %.2f)", reading.antenna_in_map.x(),
                                    reading.antenna_in_map.y()));
  }
}

void MappingNodelet::announceMap(const PublishedMap& map) {
  const nav_msgs::MapMetaData& info = map.grid.info;
  const double edge_m = static_cast<double>(info.resolution);
  const std::string size = pairText("%.1f x %.1f m", edge_m * info.width, edge_m * info.height);
  if (map.free_m2 > 0.0 && announcements_.isNews("map", size)) {
    NODELET_INFO_STREAM("The map covers " << size
                                          << pairText("; %.1f m2 are free", map.free_m2, 0.0));
  }
}

void MappingNodelet::announceMissingInput() {
  if (status_.readings > 0) {
    announcements_.forget("no reading");
    return;
  }
  if (status_.running_s < kPatience) {
    return;
  }
  if (status_.is_clock_missing) {
    if (announcements_.isNews("no reading", "clock")) {
      NODELET_WARN(
          "use_sim_time is set, but no node publishes /clock. Play a bag with --clock or start a "
          "simulator; on a real robot, run `rosparam delete /use_sim_time` and start again");
    }
    return;
  }
  for (const InputStatistics::Input& input : status_.inputs) {
    if (input.is_radio && input.messages > 0) {
      return;  // another text says what is wrong with them
    }
  }
  if (announcements_.isNews("no reading", "silent")) {
    NODELET_WARN_STREAM("No reading yet: " << whyNoReading(status_)
                                           << ". Check that the scanner runs, and the topic's "
                                              "name");
  }
}

void MappingNodelet::warnOfLosses(const ObservationQueue::Outcome& outcome) {
  std::unique_lock<std::mutex> lock(facts_mutex_);
  const std::size_t expired = facts_.expired += outcome.expired;
  const std::size_t contacts = facts_.expired_contacts += outcome.expired_contacts;
  const std::size_t overflowed = facts_.overflowed += outcome.overflowed;
  lock.unlock();
  if (outcome.expired + outcome.expired_contacts > 0) {
    mapper_->recordRejected("no transform at their stamp",
                            outcome.expired + outcome.expired_contacts);
  }
  if (outcome.expired_contacts > 0 && announcements_.isNews("expired contacts", contacts)) {
    NODELET_WARN_STREAM(contacts << " contacts dropped: tf had no transform from "
                                 << outcome.contacts_frame << " to " << ros_settings_.map_frame
                                 << " at their stamp within ros/transform_timeout ("
                                 << ros_settings_.transform_timeout_s
                                 << " s); publish it, or correct the frame of the bumper. tf's "
                                    "error: "
                                 << outcome.contacts_tf_error);
  }
  if (outcome.expired > 0) {
    if (announcements_.isNews("expired", expired)) {
      NODELET_WARN_STREAM(
          expired << " readings dropped: tf had no transform from "
                  << antennaFramesText(ros_settings_) << " to " << ros_settings_.map_frame
                  << " at their stamp within ros/transform_timeout ("
                  << ros_settings_.transform_timeout_s << " s); " << adviceOn(outcome.tf_error)
                  << ". tf's error: " << outcome.tf_error);
    }
  }
  if (outcome.unusable > 0) {
    mapper_->recordRejected("its signal is no dBm, and many such readings waited for tf",
                            outcome.unusable);
  }
  if (outcome.overflowed > 0) {
    mapper_->recordRejected("the queue of scans without transform was full (ros/max_waiting)",
                            outcome.overflowed);
    if (announcements_.isNews("overflowed", overflowed)) {
      NODELET_WARN_STREAM(overflowed
                          << " readings dropped: the queue of scans without transform is full; "
                             "raise ros/max_waiting ("
                          << ros_settings_.max_waiting << "), or find out why tf is late");
    }
  }
}

void MappingNodelet::noteFailure(const char* what, const std::exception& error) noexcept {
  changed_ = true;
  try {
    const std::string reason = reasonOf(error);
    const std::lock_guard<std::mutex> lock(facts_mutex_);
    facts_.update_failure = reason;
    if (announcements_.isNews(what, reason)) {
      NODELET_ERROR_STREAM(what << ": " << reason);
    }
  } catch (const std::exception&) {
    // As in noteFailedMessage; the next failure may be told.
  }
}

void MappingNodelet::notePoses(std::size_t jumped) {
  if (jumped > 0) {
    mapper_->recordRejected("the pose is farther than ros/max_speed allows", jumped);
    if (announcements_.isNews("jumped", pose_watch_->jumped())) {
      NODELET_WARN_STREAM(pose_watch_->jumped()
                          << " readings dropped: their pose is farther away than ros/max_speed ("
                          << ros_settings_.max_speed_m_s << " m/s) allows; check the localisation");
    }
  }
  if (announcements_.isNews("tilted", pose_watch_->tilted())) {
    constexpr double kDegrees = 180.0 / 3.14159265358979;
    NODELET_WARN_STREAM("The antenna tilted by up to "
                        << std::lround(kDegrees * pose_watch_->largestTilt()) << " degrees at "
                        << pose_watch_->tilted()
                        << " readings, more than ros/max_tilt. Their positions are projected onto "
                           "the floor; check the odometry or the IMU");
  }
  const std::lock_guard<std::mutex> lock(facts_mutex_);
  facts_.tilted = pose_watch_->tilted();
  facts_.jumped = pose_watch_->jumped();
}

void MappingNodelet::warnOfRejections() {
  for (const auto& [reason, count] : statistics_.takeRejected()) {
    mapper_->recordRejected(reason, count);
  }
  for (const auto& [result, count] : mapper_->rejections().count) {
    if (!announcements_.isNews(toString(result), count)) {
      continue;
    }
    if (result == InsertResult::kUnknownAccessPoint) {
      NODELET_INFO_STREAM(count << " readings so far are of access points that are not in the "
                                   "table. Radios of neighbours are normal; /diagnostics lists "
                                   "them");
    } else {
      NODELET_WARN_STREAM(count << " readings rejected so far: " << toString(result));
    }
  }
}

}  // namespace sfw
