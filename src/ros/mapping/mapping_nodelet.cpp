#include "ros/mapping/mapping_nodelet.h"

#include <pluginlib/class_list_macros.hpp>
#include <sstream>

#include "ros/conversion/parameters.h"
#include "structure_from_wifi/settings_io.h"

namespace sfw {
namespace {

constexpr double kWarningPeriod = 10.0;  // [s]

}  // namespace

MappingNodelet::~MappingNodelet() {
  stop_ = true;
  for (std::thread* thread : {&placing_thread_, &mapping_thread_}) {
    if (thread->joinable()) {
      thread->join();
    }
  }
}

void MappingNodelet::onInit() {
  try {
    loadParameters();
    advertise();
    placing_thread_ = std::thread([this] { run(quick_calls_, &MappingNodelet::stepPlacing); });
    mapping_thread_ = std::thread([this] { run(slow_calls_, &MappingNodelet::stepMapping); });
    subscribe();  // last: callbacks may come before onInit returns
    silence_timer_ = getNodeHandle().createSteadyTimer(
        ros::WallDuration(kWarningPeriod), [this](const ros::SteadyTimerEvent&) { warnNoInput(); });
  } catch (const std::exception& error) {
    std::istringstream problems(error.what());
    for (std::string problem; std::getline(problems, problem);) {
      NODELET_ERROR_STREAM("Mapping cannot start: " << getPrivateNodeHandle().getNamespace() << "/"
                                                    << problem);
    }
  }
}

void MappingNodelet::loadParameters() {
  const ros::NodeHandle& node = getPrivateNodeHandle();
  XmlRpc::XmlRpcValue tree;
  node.getParam(node.getNamespace(), tree);
  const YAML::Node settings = toYaml(tree);
  const ConfigReading reading = configFromYaml(settings);
  for (const std::string& warning : reading.warnings) {
    NODELET_WARN_STREAM(node.getNamespace() << "/" << warning);
  }
  config_ = reading.config;
  const AccessPointReading table =
      accessPointsFromYaml(settings.IsMap() ? settings["access_points"] : YAML::Node());
  for (const std::string& warning : table.warnings) {
    NODELET_WARN_STREAM(node.getNamespace() << "/" << warning);
  }
  access_points_ = table.access_points;
  mapper_.emplace(config_, access_points_);
  queue_.emplace(config_.ros);
  transforms_.emplace(ros::Duration(config_.ros.tf_cache_s));
}

void MappingNodelet::advertise() {
  ros::NodeHandle node = getNodeHandle();
  // Made first: with a map that cannot be made nothing may be advertised.
  const std::shared_ptr<const Snapshot> empty = mapper_->corrected({}).mapper.infer(stop_);
  publishers_.emplace(node, config_);
  publishers_->publish(empty);

  advertiseServices();
}

void MappingNodelet::subscribe() {
  ros::NodeHandle& node = getNodeHandle();
  transform_listener_ = std::make_unique<tf2_ros::TransformListener>(*transforms_, node);
  constexpr std::uint32_t kQueue = 1000;
  subscribers_.push_back(node.subscribe("wifi_scan", kQueue, &MappingNodelet::receiveScan, this));
  subscribers_.push_back(
      node.subscribe("connection", kQueue, &MappingNodelet::receiveConnection, this));
  subscribers_.push_back(node.subscribe("contact", kQueue, &MappingNodelet::receiveContact, this));
  subscribers_.push_back(
      node.subscribe("contact_points", kQueue, &MappingNodelet::receiveContactPoints, this));
}

void MappingNodelet::receiveScan(const structure_from_wifi::WifiScan& scan) {
  std::size_t malformed = 0;
  for (Observation& observation : toObservations(scan, ros::Time::now(), malformed)) {
    queue_->push(std::move(observation));
  }
  received_ = true;
  if (malformed > 0) {
    mapper_->recordRejected("bssid or age is malformed, or beyond the 1000th of a scan", malformed);
    NODELET_WARN_STREAM_THROTTLE(kWarningPeriod,
                                 "wifi_scan: " << malformed
                                               << " readings with a malformed bssid or age, or "
                                                  "beyond the 1000th, are left out");
  }
}

void MappingNodelet::receiveConnection(const wireless_msgs::Connection& connection) {
  received_ = true;
  const std::vector<Observation> observations = toObservations(connection, ros::Time::now());
  if (observations.empty()) {
    NODELET_WARN_THROTTLE(kWarningPeriod, "connection: the radio is not associated");
  }
  for (const Observation& observation : observations) {
    queue_->push(observation);
  }
}

void MappingNodelet::receiveContact(const std_msgs::Bool& contact) {
  if (contact.data != 0) {
    queue_->push(
        frontContact(config_.ros.antenna_frame, config_.path.footprint_radius_m, ros::Time::now()));
  }
}

void MappingNodelet::receiveContactPoints(const sensor_msgs::PointCloud2& cloud) {
  try {
    queue_->push(toObservation(cloud, ros::Time::now()));
  } catch (const std::exception& error) {
    NODELET_WARN_STREAM_THROTTLE(kWarningPeriod, "contact_points: " << error.what());
  }
}

void MappingNodelet::run(ros::CallbackQueue& calls, void (MappingNodelet::*step)()) {
  constexpr double kTick = 0.02;  // [s]; a service call wakes it at once
  while (!stop_) {
    calls.callAvailable(ros::WallDuration(kTick));
    try {
      (this->*step)();
    } catch (const std::exception& error) {
      changed_ = true;  // a map that failed is tried again
      NODELET_ERROR_STREAM_THROTTLE(kWarningPeriod, "Mapping goes on after: " << error.what());
    }
  }
}

void MappingNodelet::stepPlacing() {
  noticeTimeJump(ros::Time::now());
  placeObservations();
}

void MappingNodelet::noticeTimeJump(const ros::Time& now) {
  if (now < last_now_) {
    NODELET_WARN("Time jumped back: scans that wait for a transform are dropped, the map stays");
    queue_->clear();
  }
  last_now_ = now;
}

void MappingNodelet::placeObservations() {
  ObservationQueue::Outcome outcome;
  {
    const std::lock_guard<std::mutex> lock(placing_);
    outcome = queue_->place(
        *transforms_, ros::Time::now(),
        [this](const PlacedObservation& observation) { mapper_->insert(observation); });
  }
  if (outcome.placed > 0) {
    changed_ = true;
  }
  warnOfLosses(outcome);
}

void MappingNodelet::warnOfLosses(const ObservationQueue::Outcome& outcome) {
  if (outcome.expired > 0) {
    mapper_->recordRejected("no transform at their stamp", outcome.expired);
    NODELET_WARN_STREAM_THROTTLE(
        kWarningPeriod,
        outcome.expired << " readings dropped: no transform from " << config_.ros.antenna_frame
                        << " to " << config_.ros.map_frame << " at their stamp within "
                        << config_.ros.transform_timeout_s << " s; tf says: " << outcome.reason);
  }
  if (outcome.crowded_out > 0) {
    mapper_->recordRejected("more than ros/max_waiting waited for a transform",
                            outcome.crowded_out);
    NODELET_WARN_STREAM_THROTTLE(kWarningPeriod, outcome.crowded_out
                                                     << " readings dropped: more than "
                                                        "ros/max_waiting wait for a transform");
  }
  for (const auto& [insertion, count] : mapper_->rejectionCounts()) {
    NODELET_WARN_STREAM_THROTTLE(
        kWarningPeriod, "Readings left out so far, " << toString(insertion) << ": " << count);
  }
}

void MappingNodelet::stepMapping() {
  publishers_->publishDueOctomaps();
  if (ros::SteadyTime::now() < next_publication_) {
    return;
  }
  const std::optional<OdometryCorrection> latest = latestFix(config_.ros, *transforms_);
  const bool jumped =
      latest && last_map_correction_ &&
      PathCorrector::isJump(*last_map_correction_, *latest, jumpTolerance(config_.ros));
  if (changed_ || jumped) {
    next_publication_ =
        ros::SteadyTime::now() + ros::WallDuration(1.0 / config_.ros.publish_rate_hz);
    publishMap(Checks::kChanged);
  }
}

MappingNodelet::Mapping MappingNodelet::publishMap(Checks checks) {
  changed_ = false;  // before the copy: readings that come after it are for the next map
  last_map_correction_ = latestFix(config_.ros, *transforms_);
  Mapping mapping{mapper_->corrected(last_map_correction_), nullptr, {}};
  mapping.snapshot = mapping.copy.mapper.infer(stop_);
  if (!mapping.snapshot) {
    return mapping;
  }
  mapper_->keepExtent(mapping.snapshot->extent, mapping.copy);
  mapping.findings = checks == Checks::kAll ? checker_.checkAll(*mapping.snapshot, stop_)
                                            : checker_.checkChanged(*mapping.snapshot, stop_);
  if (mapping.findings.unfinished) {
    changed_ = true;  // the next refresh checks the others, even without another reading
  }
  if (stop_) {
    mapping.snapshot = nullptr;
  }
  const std::lock_guard<std::mutex> lock(publishing_);
  if (mapping.snapshot && mapping.copy.resets == mapper_->resets()) {
    publishers_->publish(mapping.snapshot, mapping.findings);
    if (checks == Checks::kChanged) {  // saving a map logs the complete list
      reportFaults(mapNotes(*mapping.snapshot, mapping.findings));
    }
  }
  return mapping;
}

void MappingNodelet::reportFaults(const std::vector<MapNote>& notes) {
  if (clear_reported_.exchange(false)) {
    reported_faults_.clear();
  }
  for (const MapNote& note : notes) {
    if (isFault(note) && reported_faults_.emplace(note.kind, note.about).second) {
      NODELET_WARN_STREAM(note.text);
    }
  }
}

void MappingNodelet::warnNoInput() {
  if (ros::Time::isSimTime() && ros::Time::now().isZero()) {
    NODELET_WARN(
        "use_sim_time is set and nobody publishes /clock: play a bag or simulate, or, on a real "
        "robot, rosparam delete /use_sim_time and start again");
  } else if (!received_) {
    NODELET_WARN_STREAM("Nothing was heard yet on " << subscribers_[0].getTopic() << " or "
                                                    << subscribers_[1].getTopic());
  } else {
    silence_timer_.stop();
  }
}

}  // namespace sfw

PLUGINLIB_EXPORT_CLASS(sfw::MappingNodelet, nodelet::Nodelet)
