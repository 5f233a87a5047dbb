#include "ros/mapping/mapping_nodelet.h"

#include <pluginlib/class_list_macros.hpp>
#include <sstream>

#include "ros/conversion/parameters.h"
#include "structure_from_wifi/access_points_io.h"

namespace sfw {
namespace {

constexpr double kWarningPeriod = 10.0;  // [s]

}  // namespace

MappingNodelet::~MappingNodelet() {
  stop_ = true;
  for (std::thread* thread : {&locating_thread_, &mapping_thread_}) {
    if (thread->joinable()) {
      thread->join();
    }
  }
}

void MappingNodelet::onInit() {
  try {
    loadParameters();
    advertise();
    locating_thread_ = std::thread([this] { run(quick_calls_, &MappingNodelet::stepLocating); });
    mapping_thread_ = std::thread([this] { run(slow_calls_, &MappingNodelet::stepMapping); });
    subscribe();  // last: callbacks may come before onInit returns
    no_input_timer_ = getNodeHandle().createSteadyTimer(
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
  const MappingSettings reading = mappingSettingsFromYaml(settings);
  for (const std::string& warning : reading.warnings) {
    NODELET_WARN_STREAM(node.getNamespace() << "/" << warning);
  }
  config_ = reading.config;
  ros_settings_ = reading.ros;
  const AccessPointReading table =
      accessPointsFromYaml(settings.IsMap() ? settings["access_points"] : YAML::Node());
  for (const std::string& warning : table.warnings) {
    NODELET_WARN_STREAM(node.getNamespace() << "/" << warning);
  }
  access_points_ = table.access_points;
  mapper_.emplace(config_, access_points_, jumpTolerance(ros_settings_));
  queue_.emplace(ros_settings_);
  transforms_.emplace(ros::Duration(ros_settings_.tf_cache_s));
}

void MappingNodelet::advertise() {
  ros::NodeHandle node = getNodeHandle();
  // The map is inferred first. If no map is possible, nothing may be advertised.
  const std::shared_ptr<const Snapshot> empty = mapper_->corrected({}).mapper.infer(stop_);
  publishers_.emplace(node, ros_settings_.map_frame, config_);
  publishers_->publish(empty);

  advertiseServices();
}

void MappingNodelet::subscribe() {
  transform_listener_ = std::make_unique<tf2_ros::TransformListener>(*transforms_, getNodeHandle());
  forEachInput([this](const auto& input) { subscribeTo(input); });
}

template <class Message>
void MappingNodelet::subscribeTo(const Input<Message>& input) {
  constexpr std::uint32_t kQueue = 1000;
  const boost::function<void(const boost::shared_ptr<const Message>&)> callback =
      [this, input](const boost::shared_ptr<const Message>& message) { receive(input, *message); };
  subscribers_.push_back(getNodeHandle().subscribe<Message>(input.topic, kQueue, callback));
  if (input.is_radio) {
    radio_topics_ += (radio_topics_.empty() ? "" : " or ") + subscribers_.back().getTopic();
  }
}

template <class Message>
void MappingNodelet::receive(const Input<Message>& input, const Message& message) {
  Conversion conversion = input.convert(
      message, {ros::Time::now(), ros_settings_.antenna_frame, config_.path.footprint_radius_m});
  for (Observation& observation : conversion.observations) {
    queue_->push(std::move(observation));
  }
  received_ = received_ || input.is_radio;
  if (conversion.rejected > 0) {
    mapper_->recordRejected(conversion.problem, conversion.rejected);
    NODELET_WARN_STREAM_THROTTLE(kWarningPeriod, input.topic
                                                     << ": " << conversion.rejected
                                                     << " rejected: " << conversion.problem);
  } else if (!conversion.problem.empty()) {
    NODELET_WARN_STREAM_THROTTLE(kWarningPeriod, input.topic << ": " << conversion.problem);
  }
}

void MappingNodelet::run(ros::CallbackQueue& calls, void (MappingNodelet::*step)()) {
  constexpr double kTick = 0.02;  // [s]; a service call wakes it at once
  while (!stop_) {
    calls.callAvailable(ros::WallDuration(kTick));
    try {
      (this->*step)();
    } catch (const std::exception& error) {
      changed_ = true;
      NODELET_ERROR_STREAM_THROTTLE(
          kWarningPeriod, "The map update failed and will be tried again: " << error.what());
    }
  }
}

void MappingNodelet::stepLocating() {
  noticeTimeJump(ros::Time::now());
  locateObservations();
}

void MappingNodelet::noticeTimeJump(const ros::Time& now) {
  if (now < last_now_) {
    NODELET_WARN(
        "ROS time jumped back: the queue of scans without transform is dropped, and the map is "
        "kept");
    queue_->clear();
  }
  last_now_ = now;
}

void MappingNodelet::locateObservations() {
  ObservationQueue::Outcome outcome;
  {
    const std::lock_guard<std::mutex> lock(locating_);
    outcome = queue_->locate(
        *transforms_, ros::Time::now(),
        [this](const LocatedObservation& observation) { mapper_->insert(observation); });
  }
  if (outcome.located > 0) {
    changed_ = true;
  }
  warnOfLosses(outcome);
}

void MappingNodelet::warnOfLosses(const ObservationQueue::Outcome& outcome) {
  if (outcome.expired > 0) {
    mapper_->recordRejected("no transform at their stamp", outcome.expired);
    NODELET_WARN_STREAM_THROTTLE(
        kWarningPeriod, outcome.expired
                            << " readings dropped: tf had no transform from "
                            << ros_settings_.antenna_frame << " to " << ros_settings_.map_frame
                            << " at their stamp within ros/transform_timeout ("
                            << ros_settings_.transform_timeout_s
                            << " s); start the localisation, or correct ros/antenna_frame and "
                               "ros/map_frame. tf's error: "
                            << outcome.tf_error);
  }
  if (outcome.overflowed > 0) {
    mapper_->recordRejected("the queue of scans without transform was full (ros/max_waiting)",
                            outcome.overflowed);
    NODELET_WARN_STREAM_THROTTLE(
        kWarningPeriod, outcome.overflowed
                            << " readings dropped: the queue of scans without transform is full; "
                               "raise ros/max_waiting ("
                            << ros_settings_.max_waiting << "), or find out why tf is late");
  }
  std::string rejected;  // one line, because each place in the code is throttled by itself
  for (const auto& [result, count] : mapper_->rejectionCounts()) {
    rejected += (rejected.empty() ? "" : "; ") + std::to_string(count) +
                " readings rejected so far: " + toString(result);
  }
  if (!rejected.empty()) {
    NODELET_WARN_STREAM_THROTTLE(kWarningPeriod, rejected);
  }
}

void MappingNodelet::stepMapping() {
  publishers_->publishDueOctomaps();
  if (ros::SteadyTime::now() < next_publication_) {
    return;
  }
  const std::optional<OdometryCorrection> latest = latestCorrection(ros_settings_, *transforms_);
  const bool jumped =
      latest && last_map_correction_ &&
      PathCorrector::isJump(*last_map_correction_, *latest, jumpTolerance(ros_settings_));
  if (changed_ || jumped) {
    next_publication_ =
        ros::SteadyTime::now() + ros::WallDuration(1.0 / ros_settings_.publish_rate_hz);
    publishMap(Checks::kChanged);
  }
}

MappingNodelet::Mapping MappingNodelet::publishMap(Checks checks) {
  changed_ = false;  // before the copy: later readings are for the next map
  last_map_correction_ = latestCorrection(ros_settings_, *transforms_);
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
        "use_sim_time is set, but no node publishes /clock. Play a bag with --clock or start a "
        "simulator; on a real robot, run `rosparam delete /use_sim_time` and start again");
  } else if (!received_) {
    NODELET_WARN_STREAM("No reading yet on "
                        << radio_topics_ << ": check that the scanner runs, and the topic's name");
  } else {
    no_input_timer_.stop();
  }
}

}  // namespace sfw

PLUGINLIB_EXPORT_CLASS(sfw::MappingNodelet, nodelet::Nodelet)
