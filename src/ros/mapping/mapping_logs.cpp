// What the mapping nodelet tells its user: diagnostics, and logs that say each thing once.

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

}  // namespace

void MappingNodelet::advertiseDiagnostics() {
  using Wrapper = diagnostic_updater::DiagnosticStatusWrapper;
  diagnostics_.emplace(getNodeHandle(), getPrivateNodeHandle(),
                       getPrivateNodeHandle().getNamespace());
  diagnostics_->setHardwareID("none");
  diagnostics_->add("inputs", [this](Wrapper& to) { describeInputs(status_, to); });
  diagnostics_->add("transforms", [this](Wrapper& to) { describeTransforms(status_, to); });
  diagnostics_->add("map", [this](Wrapper& to) { describeMap(status_, to); });
}

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
  if (!observation.readings.empty() && announcements_.isNews("first reading")) {
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

void MappingNodelet::diagnose() {
  const ros::SteadyTime now = ros::SteadyTime::now();
  if (now < next_diagnosis_) {
    return;
  }
  next_diagnosis_ = now + ros::WallDuration(1.0);
  status_ = status();
  if (diagnostics_) {
    diagnostics_->force_update();  // update() would stop with the simulated clock
  }
  if (failure_.empty()) {
    subscribeAnew();
    mapper_->recordFrames(status_.frames);
    announceMissingInput();
    if (announcements_.isNews("infinite transforms", status_.infinite_transforms)) {
      NODELET_WARN_STREAM(status_.infinite_transforms
                          << " transforms on /tf are not finite and left out; look for the node "
                             "that publishes them");
    }
  }
}

TransformStatus MappingNodelet::transformStatusOfRobots() const {
  std::optional<TransformStatus> first;
  for (const RosSettings& robot : robots_->settings()) {
    TransformStatus status = transformStatus(robot, *transforms_, ros::Time::now());
    if (!status.tf_error.empty() || status.age_s > ros_settings_.transform_timeout_s) {
      return status;
    }
    first = first ? first : std::optional(std::move(status));
  }
  return *first;
}

FrameFinding MappingNodelet::frameFindingOfRobots() const {
  FrameFinding finding;
  for (const RosSettings& robot : robots_->settings()) {
    if (finding.published_twice.empty()) {
      finding = transform_watch_.finding(robot.antenna_frame);
    }
  }
  return finding;
}

MappingStatus MappingNodelet::status() const {
  MappingStatus status;
  const ros::SteadyTime now = ros::SteadyTime::now();
  status.now_s = now.toSec();
  status.running_s = (now - started_).toSec();
  status.failure = failure_;
  if (!failure_.empty()) {
    return status;
  }
  status.is_clock_missing = ros::Time::isSimTime() && ros::Time::now().isZero();
  status.inputs = statistics_.inputs(status.now_s);
  status.transform = transformStatusOfRobots();
  status.frames = frameFindingOfRobots();
  status.frames.floors_m = floors_.heights();
  status.infinite_transforms = transform_intake_ ? transform_intake_->leftOut() : 0;
  status.transform_timeout_s = ros_settings_.transform_timeout_s;
  status.is_paused = paused_;
  status.waiting = queue_->size();
  status.readings = mapper_->readings();
  status.rejections = mapper_->rejections();
  if (const auto last = publishers_->last()) {
    status.map = last->snapshot;
    status.findings = last->findings;
    status.free_m2 = last->free_m2;
  }
  const std::lock_guard<std::mutex> lock(facts_mutex_);
  status.update_failure = facts_.update_failure;
  status.autosave_failure = facts_.autosave_failure;
  status.inference_s = facts_.inference_s;
  status.expired = facts_.expired;
  status.overflowed = facts_.overflowed;
  status.tilted = facts_.tilted;
  status.jumped = facts_.jumped;
  return status;
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
  facts_mutex_.lock();
  const std::size_t expired = facts_.expired += outcome.expired;
  const std::size_t overflowed = facts_.overflowed += outcome.overflowed;
  facts_mutex_.unlock();
  if (outcome.expired > 0) {
    mapper_->recordRejected("no transform at their stamp", outcome.expired);
    if (announcements_.isNews("expired", expired)) {
      NODELET_WARN_STREAM(
          expired << " readings dropped: tf had no transform from "
                  << antennaFramesText(ros_settings_) << " to " << ros_settings_.map_frame
                  << " at their stamp within ros/transform_timeout ("
                  << ros_settings_.transform_timeout_s
                  << " s); start the localisation, or correct ros/antenna_frame and "
                     "ros/map_frame. tf's error: "
                  << outcome.tf_error);
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

void MappingNodelet::noteFailedMessage(const Source& source, const std::exception& error) noexcept {
  try {
    const std::string problem = std::string("it could not be processed: ") + reasonOf(error);
    statistics_.count(source.index, rejection(problem), ros::SteadyTime::now().toSec());
    if (announcements_.isNews(source.topic + " failed", problem)) {
      NODELET_ERROR_STREAM("A message on " << source.topic << " is left out: " << problem);
    }
  } catch (const std::exception&) {
    // Not even the memory for the text is there; the next message may be told.
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
