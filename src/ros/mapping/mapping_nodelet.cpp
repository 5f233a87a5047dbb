#include "ros/mapping/mapping_nodelet.h"

#include <pluginlib/class_list_macros.hpp>
#include <sstream>

#include "base/failure.h"
#include "files/text.h"
#include "ros/conversion/access_point_parameters.h"
#include "ros/conversion/parameters.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {

MappingNodelet::~MappingNodelet() {
  stop_ = true;
  for (std::thread* thread : {&locating_thread_, &mapping_thread_}) {
    if (thread->joinable()) {
      thread->join();
    }
  }
  if (mapper_ && unsaved_) {
    autosave();
  }
}

void MappingNodelet::onInit() {
  started_ = ros::SteadyTime::now();
  try {
    advertiseDiagnostics();
    start();
  } catch (const std::exception& error) {
    giveUp(error);
  }
  try {
    // Without a map, this thread tells diagnostics why.
    locating_thread_ = std::thread([this] { run(quick_calls_, kLocatingSteps); });
  } catch (const std::exception& error) {
    giveUp(error);
  }
}

void MappingNodelet::start() {
  loadParameters();
  advertise();
  subscribe();  // callbacks come from now on
  announceStart();
  mapping_thread_ = std::thread([this] { run(slow_calls_, kMappingSteps); });
}

void MappingNodelet::giveUp(const std::exception& error) noexcept {
  {
    const std::lock_guard<std::mutex> lock(subscribing_);
    subscriptions_.clear();
  }
  transform_intake_.reset();
  if (mapping_thread_.joinable()) {
    stop_ = true;
    mapping_thread_.join();
    stop_ = false;
  }
  click_subscriber_.shutdown();
  live_server_.reset();
  servers_.clear();
  localisation_.reset();
  publishers_.reset();
  try {
    failure_ = reasonOf(error);
    std::istringstream problems(failure_);
    for (std::string problem; std::getline(problems, problem);) {
      NODELET_ERROR_STREAM("Mapping cannot start: " << problem);
    }
  } catch (const std::exception&) {
    failure_ = "out of memory";  // so short that it needs none
  }
}

void MappingNodelet::loadParameters() {
  try {
    readParameters();
  } catch (const InputError& error) {
    throw InputError(withPrefix(getPrivateNodeHandle().getNamespace() + "/", error.what()));
  }
  try {
    mapper_.emplace(config_, access_points_, jumpTolerance(ros_settings_));
  } catch (const InputError& error) {
    throw InputError(withPrefix(getPrivateNodeHandle().getNamespace() + ": ", error.what()));
  }
  queue_.emplace(ros_settings_);
  robots_.emplace(ros_settings_);
  refresh_rule_.emplace(config_.tomography.bin_size_m);
  pose_watch_.emplace(ros_settings_.max_tilt_rad, ros_settings_.max_speed_m_s);
  transforms_.emplace(ros::Duration(ros_settings_.tf_cache_s));
}

void MappingNodelet::readParameters() {
  const ros::NodeHandle& node = getPrivateNodeHandle();
  const YAML::Node settings = parametersOf(node);
  const MappingSettings reading = mappingSettingsFromYaml(settings);
  for (const std::string& warning : reading.warnings) {
    NODELET_WARN_STREAM(node.getNamespace() << "/" << warning);
  }
  config_ = reading.config;
  ros_settings_ = reading.ros;
  scan_settings_ = reading.scan;
  const AccessPointReading table = accessPointsOfParameters(settings);
  for (const std::string& warning : table.warnings) {
    NODELET_WARN_STREAM(node.getNamespace() << "/" << warning);
  }
  access_points_ = table.access_points;
}

void MappingNodelet::advertise() {
  ros::NodeHandle node = getNodeHandle();
  // The map is inferred first. If no map is possible, nothing may be advertised.
  const std::shared_ptr<const Snapshot> empty = mapper_->corrected({}).mapper.infer(stop_);
  using Updates = MapPublishers::Updates;
  warnOfOtherMappers();
  publishers_.emplace(node, ros_settings_.map_frame, config_,
                      ros_settings_.map_updates ? Updates::kRectangles : Updates::kNone);
  publishers_->publish(empty);
  if (ros_settings_.localisation_rate_hz > 0.0) {
    localisation_.emplace(getPrivateNodeHandle(), robots_->settings().front(), *transforms_);
  }

  advertiseServices();
  advertiseLiveSettings();
}

const std::vector<MappingNodelet::Step> MappingNodelet::kLocatingSteps{
    {&MappingNodelet::takeInReadings, "The readings cannot be taken in and will be tried again"},
    {&MappingNodelet::diagnose, "The diagnostics failed and will be tried again"}};

const std::vector<MappingNodelet::Step> MappingNodelet::kMappingSteps{
    {&MappingNodelet::resumeOnce, "The last session could not be looked for"},
    {&MappingNodelet::autosaveIfDue, "The session could not be saved and will be tried again"},
    {&MappingNodelet::publishWhatIsDue, "The map was not published and will be again"},
    {&MappingNodelet::updateMap, "The map update failed and will be tried again"}};

void MappingNodelet::run(ros::CallbackQueue& calls, const std::vector<Step>& steps) {
  constexpr double kTick = 0.02;  // [s]; a service call wakes it at once
  while (!stop_) {
    try {
      calls.callAvailable(ros::WallDuration(kTick));
    } catch (const std::exception& error) {
      noteFailure("A service call failed", error);
    }
    for (const Step& step : steps) {
      try {
        (this->*step.take)();
      } catch (const std::exception& error) {
        noteFailure(step.failure, error);
      }
    }
  }
}

void MappingNodelet::takeInReadings() {
  if (failure_.empty()) {
    noticeTimeJump(ros::Time::now());
    locateObservations();
  }
}

void MappingNodelet::noticeTimeJump(const ros::Time& now) {
  const ros::Time before = std::exchange(last_now_, now);
  if (now < before) {
    const bool is_reset = ros_settings_.on_time_jump == "reset";
    NODELET_WARN_STREAM("ROS time jumped back by "
                        << before.toSec() - now.toSec()
                        << " s: readings without a transform are dropped, and the map is "
                        << (is_reset ? "reset" : "kept") << " (ros/on_time_jump)");
    queue_->clear();
    pose_watch_->clear();
    if (localisation_) {
      localisation_->startAgain();
    }
    if (is_reset) {
      startAnew();
    }
  }
}

bool MappingNodelet::insert(const LocatedObservation& observation) {
  if (!pose_watch_->isUsable(observation)) {
    return false;
  }
  const std::size_t kept = mapper_->insert(observation);
  if (!observation.readings.empty()) {
    floors_.observe(observation.sensor_height_m);
  }
  if (kept > 0) {
    announceFirstReading(observation);
  }
  return refresh_rule_->isNews(observation);
}

void MappingNodelet::locateObservations() {
  ObservationQueue::Outcome outcome;
  bool is_news = false;
  {
    const std::lock_guard<std::mutex> lock(locating_);
    const std::size_t jumped = pose_watch_->jumped();
    outcome = queue_->locate(*transforms_, ros::Time::now(),
                             [this, &is_news](const LocatedObservation& observation) {
                               is_news = insert(observation) || is_news;
                             });
    notePoses(pose_watch_->jumped() - jumped);
  }
  if (outcome.located > 0) {
    unsaved_ = true;
  }
  if (is_news) {
    changed_ = true;
  }
  warnOfLosses(outcome);
  warnOfRejections();
}

}  // namespace sfw

PLUGINLIB_EXPORT_CLASS(sfw::MappingNodelet, nodelet::Nodelet)
