// The services of the mapping nodelet.

#include <octomap/OcTree.h>

#include <cstdlib>
#include <fstream>

#include "ros/conversion/message_conversion.h"
#include "ros/mapping/mapping_nodelet.h"
#include "structure_from_wifi/map_files.h"
#include "structure_from_wifi/map_notes.h"
#include "structure_from_wifi/octomap_export.h"

namespace sfw {
namespace {

/// Whether a name stays in its parent directory: it has only letters, digits, '.', '_' and '-'.
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

/// Whether a directory contains a recording with readings.
bool holdsReadings(const std::string& directory) {
  std::ifstream file(directory + "/readings.csv");
  std::string line;
  return std::getline(file, line) && std::getline(file, line);
}

}  // namespace

void MappingNodelet::advertiseServices() {
  ros::NodeHandle node = getNodeHandle();
  ros::NodeHandle private_node = getPrivateNodeHandle();
  using Map = nav_msgs::GetMap;
  using Octomap = octomap_msgs::GetOctomap;
  using Save = structure_from_wifi::SaveMap;
  using Trigger = std_srvs::Trigger;
  node.setCallbackQueue(&quick_calls_);
  private_node.setCallbackQueue(&quick_calls_);
  servers_.push_back(node.advertiseService<Map::Request, Map::Response>(
      "dynamic_map", [this](auto&, auto& response) { return serveMap(response); }));
  servers_.push_back(private_node.advertiseService<Trigger::Request, Trigger::Response>(
      "reset", [this](auto&, auto& response) { return reset(response); }));
  node.setCallbackQueue(&slow_calls_);
  private_node.setCallbackQueue(&slow_calls_);
  servers_.push_back(node.advertiseService<Octomap::Request, Octomap::Response>(
      "octomap_binary", [this](auto&, auto& response) { return serveOctomap(true, response); }));
  servers_.push_back(node.advertiseService<Octomap::Request, Octomap::Response>(
      "octomap_full", [this](auto&, auto& response) { return serveOctomap(false, response); }));
  servers_.push_back(private_node.advertiseService<Save::Request, Save::Response>(
      "save_map", [this](auto& request, auto& response) { return saveMap(request, response); }));
}

bool MappingNodelet::serveMap(nav_msgs::GetMap::Response& response) {
  response.map = publishers_->last()->grid;
  return true;
}

bool MappingNodelet::reset(std_srvs::Trigger::Response& response) {
  // The mapping thread may be inferring a map of the old readings. It does not publish that map.
  const std::lock_guard<std::mutex> lock(publishing_);
  mapper_->reset();
  queue_->clear();
  clear_reported_ = true;
  forget_directories_ = true;
  announcements_.clear();
  const std::shared_ptr<const Snapshot> empty = mapper_->corrected({}).mapper.infer(stop_);
  if (empty) {
    publishers_->publish(empty);
    response.success = 1;
  }
  return true;
}

bool MappingNodelet::serveOctomap(bool binary, octomap_msgs::GetOctomap::Response& response) {
  const std::shared_ptr<const PublishedMap> map = publishers_->last();
  if (!octomapReaches(map->snapshot->belief.geometry())) {
    NODELET_ERROR(
        "No OctoMap is possible: the map lies more than 32768 cells from the frame's origin. Use a "
        "frame that begins nearer, or raise map/resolution");
    return false;
  }
  const auto tree = toOctomap(map->snapshot->belief, config_.octomap);
  response.map =
      binary ? toBinaryOctomap(*tree, map->grid.header) : toFullOctomap(*tree, map->grid.header);
  return true;
}

std::string MappingNodelet::whyNothingToSave() const {
  const std::string reason = whyNoReading(status());
  return "there are no readings yet" + (reason.empty() ? "" : "; " + reason);
}

std::string MappingNodelet::directoryToSave(const std::string& name) {
  if (forget_directories_.exchange(false)) {
    own_directories_.clear();
  }
  const std::string wanted = withHome(ros_settings_.save_directory) + "/" + name;
  std::string directory = wanted;
  for (int i = 2; own_directories_.count(directory) == 0 && holdsReadings(directory); ++i) {
    directory = wanted + "_" + std::to_string(i);
  }
  return directory;
}

bool MappingNodelet::saveMap(const structure_from_wifi::SaveMap::Request& request,
                             structure_from_wifi::SaveMap::Response& response) {
  response.success = 0;
  if (!isPlainName(request.directory)) {
    response.message =
        "directory must be a name of letters, digits, '.', '_' and '-' that does not start with "
        "'.'";
    return true;
  }
  try {
    locateObservations();
    const Mapping mapping = publishMap(Checks::kAll);
    if (!mapping.snapshot) {
      response.message = "the map was not saved: the mapping node is shutting down";
      return true;
    }
    const Mapper& mapper = mapping.copy.mapper;
    if (mapper.readings().empty()) {
      response.message = "nothing was saved: " + whyNothingToSave();
      return true;
    }
    const std::string directory = directoryToSave(request.directory);
    for (const MapNote& note : mapNotes(*mapping.snapshot, mapping.findings)) {
      NODELET_WARN_STREAM(note.text);
    }
    writeRecording(mapper.readings(), mapper.contacts(), *mapping.snapshot, directory);
    writeMapFiles(*mapping.snapshot, config_, directory, mapping.findings);
    own_directories_.insert(directory);
    response.success = 1;
    response.message = directory;
  } catch (const std::exception& error) {
    response.message = error.what();
  }
  return true;
}

}  // namespace sfw
