#include "mapping_nodelet.h"

#include <octomap/OcTree.h>

#include <cstdlib>
#include <pluginlib/class_list_macros.hpp>
#include <sstream>

#include "message_conversion.h"
#include "parameters.h"
#include "structure_from_wifi/config_reader.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/map_files.h"
#include "structure_from_wifi/octomap_export.h"

namespace sfw {
namespace {

constexpr double kWarningPeriod = 10.0;  // [s]

/// A directory's name that cannot lead out of its parent: letters, digits, '.', '_' and '-'.
bool isPlainName(const std::string& name) {
  constexpr char kAllowed[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-";
  constexpr std::size_t kLongest = 200;
  return !name.empty() && name.size() <= kLongest && name.front() != '.' &&
         name.find_first_not_of(kAllowed) == std::string::npos;
}

std::string withHome(const std::string& directory) {
  const char* home = std::getenv("HOME");
  const bool starts_at_home = directory.compare(0, 2, "~/") == 0;
  return starts_at_home && home != nullptr ? home + directory.substr(1) : directory;
}

}  // namespace

MappingNodelet::~MappingNodelet() {
  stop_ = true;
  if (thread_.joinable()) {
    thread_.join();
  }
}

void MappingNodelet::onInit() {
  try {
    loadParameters();
    advertise();
    thread_ = std::thread([this] { run(); });
    subscribe();  // last: callbacks may come before onInit returns
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
  access_points_ =
      accessPointsFromYaml(settings.IsMap() ? settings["access_points"] : YAML::Node());
  mapper_.emplace(config_, access_points_);
  queue_.emplace(config_.ros);
  transforms_.emplace(ros::Duration(config_.ros.tf_cache));
}

void MappingNodelet::advertise() {
  ros::NodeHandle node = getNodeHandle();
  // Made first: with a map that cannot be made nothing may be advertised.
  const std::shared_ptr<const Snapshot> empty = mapper_->infer(stop_);
  publishers_.emplace(node, config_);
  publishers_->publish(empty);

  ros::NodeHandle services = getNodeHandle();
  ros::NodeHandle private_services = getPrivateNodeHandle();
  services.setCallbackQueue(&service_calls_);
  private_services.setCallbackQueue(&service_calls_);
  using Map = nav_msgs::GetMap;
  using Octomap = octomap_msgs::GetOctomap;
  using Save = structure_from_wifi::SaveMap;
  using Trigger = std_srvs::Trigger;
  servers_.push_back(services.advertiseService<Map::Request, Map::Response>(
      "dynamic_map", [this](auto&, auto& response) { return serveMap(response); }));
  servers_.push_back(services.advertiseService<Octomap::Request, Octomap::Response>(
      "octomap_binary", [this](auto&, auto& response) { return serveOctomap(true, response); }));
  servers_.push_back(services.advertiseService<Octomap::Request, Octomap::Response>(
      "octomap_full", [this](auto&, auto& response) { return serveOctomap(false, response); }));
  servers_.push_back(private_services.advertiseService<Save::Request, Save::Response>(
      "save_map", [this](auto& request, auto& response) { return saveMap(request, response); }));
  servers_.push_back(private_services.advertiseService<Trigger::Request, Trigger::Response>(
      "reset", [this](auto&, auto& response) { return reset(response); }));
}

void MappingNodelet::subscribe() {
  ros::NodeHandle& node = getNodeHandle();
  transform_listener_.emplace(*transforms_, node);
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
  if (malformed > 0) {
    NODELET_WARN_STREAM_THROTTLE(kWarningPeriod,
                                 "wifi_scan: " << malformed
                                               << " readings with a malformed bssid or age, or "
                                                  "beyond the 1000th, are left out");
  }
}

void MappingNodelet::receiveConnection(const wireless_msgs::Connection& connection) {
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
    queue_->push(frontContact(config_.ros.antenna_frame, config_.inference.footprint_radius,
                              ros::Time::now()));
  }
}

void MappingNodelet::receiveContactPoints(const sensor_msgs::PointCloud2& cloud) {
  try {
    queue_->push(toObservation(cloud, ros::Time::now()));
  } catch (const std::exception& error) {
    NODELET_WARN_STREAM_THROTTLE(kWarningPeriod, "contact_points: " << error.what());
  }
}

void MappingNodelet::run() {
  constexpr double kTick = 0.02;  // [s]; a service call wakes it at once
  while (!stop_) {
    service_calls_.callAvailable(ros::WallDuration(kTick));
    try {
      step();
    } catch (const std::exception& error) {
      NODELET_ERROR_STREAM_THROTTLE(kWarningPeriod, "Mapping goes on after: " << error.what());
    }
  }
}

void MappingNodelet::step() {
  const ros::Time now = ros::Time::now();
  noticeTimeJump(now);
  placeObservations(now);
  publishers_->publishToNewcomers();
  if (changed_ && ros::SteadyTime::now() >= next_publication_) {
    next_publication_ = ros::SteadyTime::now() + ros::WallDuration(1.0 / config_.ros.publish_rate);
    publishMap();
  }
}

void MappingNodelet::noticeTimeJump(const ros::Time& now) {
  if (now < last_now_) {
    NODELET_WARN("Time jumped back: scans that wait for a transform are dropped, the map stays");
    queue_->clear();
  }
  last_now_ = now;
}

void MappingNodelet::placeObservations(const ros::Time& now) {
  const ObservationQueue::Outcome outcome = queue_->place(*transforms_, now, *mapper_);
  changed_ = changed_ || outcome.placed > 0;
  if (outcome.expired > 0) {
    NODELET_WARN_STREAM_THROTTLE(
        kWarningPeriod, outcome.expired
                            << " readings dropped: no transform from " << config_.ros.antenna_frame
                            << " to " << config_.ros.map_frame << " at their stamp within "
                            << config_.ros.transform_timeout << " s; tf says: " << outcome.reason);
  }
  if (outcome.crowded_out > 0) {
    NODELET_WARN_STREAM_THROTTLE(kWarningPeriod, outcome.crowded_out
                                                     << " readings dropped: more than "
                                                        "ros/max_waiting wait for a transform");
  }
  for (const auto& [insertion, count] : mapper_->rejections().count) {
    NODELET_WARN_STREAM_THROTTLE(
        kWarningPeriod, "Readings left out so far, " << toString(insertion) << ": " << count);
  }
}

bool MappingNodelet::publishMap() {
  const std::shared_ptr<const Snapshot> snapshot = mapper_->infer(stop_);
  if (!snapshot) {
    return false;
  }
  publishers_->publish(snapshot);
  changed_ = false;
  return true;
}

bool MappingNodelet::serveMap(nav_msgs::GetMap::Response& response) {
  response.map = publishers_->lastMap();
  return true;
}

bool MappingNodelet::serveOctomap(bool binary, octomap_msgs::GetOctomap::Response& response) {
  const auto tree = toOctomap(publishers_->lastSnapshot()->belief, config_.octomap);
  const std_msgs::Header& header = publishers_->lastMap().header;
  response.map = binary ? toBinaryOctomap(*tree, header) : toFullOctomap(*tree, header);
  return true;
}

bool MappingNodelet::saveMap(const structure_from_wifi::SaveMap::Request& request,
                             structure_from_wifi::SaveMap::Response& response) {
  response.success = 0;
  if (!isPlainName(request.directory)) {
    response.message =
        "directory must be a plain name: letters, digits, '.', '_', '-', not starting with '.'";
    return true;
  }
  const std::string directory = withHome(config_.ros.save_directory) + "/" + request.directory;
  try {
    placeObservations(ros::Time::now());
    if (!publishMap()) {
      response.message = "mapping is shutting down";
      return true;
    }
    const Snapshot& snapshot = *publishers_->lastSnapshot();
    writeRecording(mapper_->readings(), mapper_->contacts(), snapshot, directory);
    writeMapFiles(snapshot, config_, directory);
    response.success = 1;
    response.message = directory;
  } catch (const std::exception& error) {
    response.message = error.what();
  }
  return true;
}

bool MappingNodelet::reset(std_srvs::Trigger::Response& response) {
  mapper_->reset();
  queue_->clear();
  response.success = static_cast<unsigned char>(publishMap());
  return true;
}

}  // namespace sfw

PLUGINLIB_EXPORT_CLASS(sfw::MappingNodelet, nodelet::Nodelet)
