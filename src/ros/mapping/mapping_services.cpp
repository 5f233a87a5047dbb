// The services of the mapping nodelet.

#include <octomap/OcTree.h>

#include <cmath>

#include "base/failure.h"
#include "ros/conversion/message_conversion.h"
#include "ros/mapping/mapping_nodelet.h"
#include "ros/mapping/region.h"
#include "structure_from_wifi/octomap_export.h"

namespace sfw {

void MappingNodelet::advertiseServices() {
  ros::NodeHandle node = getNodeHandle();
  ros::NodeHandle private_node = getPrivateNodeHandle();
  using Map = nav_msgs::GetMap;
  using Octomap = octomap_msgs::GetOctomap;
  using Clear = structure_from_wifi::ClearRegion;
  using Load = structure_from_wifi::LoadMap;
  using Save = structure_from_wifi::SaveMap;
  using SetBool = std_srvs::SetBool;
  using Trigger = std_srvs::Trigger;
  node.setCallbackQueue(&quick_calls_);
  private_node.setCallbackQueue(&quick_calls_);
  servers_.push_back(node.advertiseService<Map::Request, Map::Response>(
      "dynamic_map", [this](auto&, auto& response) { return serveMap(response); }));
  servers_.push_back(private_node.advertiseService<Trigger::Request, Trigger::Response>(
      "reset", [this](auto&, auto& response) { return reset(response); }));
  servers_.push_back(private_node.advertiseService<SetBool::Request, SetBool::Response>(
      "pause", [this](auto& request, auto& response) { return pause(request, response); }));
  node.setCallbackQueue(&slow_calls_);
  private_node.setCallbackQueue(&slow_calls_);
  servers_.push_back(node.advertiseService<Octomap::Request, Octomap::Response>(
      "octomap_binary", [this](auto&, auto& response) { return serveOctomap(true, response); }));
  servers_.push_back(node.advertiseService<Octomap::Request, Octomap::Response>(
      "octomap_full", [this](auto&, auto& response) { return serveOctomap(false, response); }));
  servers_.push_back(private_node.advertiseService<Save::Request, Save::Response>(
      "save_map", [this](auto& request, auto& response) { return saveMap(request, response); }));
  servers_.push_back(private_node.advertiseService<Load::Request, Load::Response>(
      "load_map", [this](auto& request, auto& response) { return loadMap(request, response); }));
  servers_.push_back(private_node.advertiseService<Clear::Request, Clear::Response>(
      "clear_region",
      [this](auto& request, auto& response) { return clearRegion(request, response); }));
  constexpr std::uint32_t kQueue = 10;
  click_subscriber_ =
      node.subscribe("clicked_point", kQueue, &MappingNodelet::placeAccessPoint, this);
}

bool MappingNodelet::serveMap(nav_msgs::GetMap::Response& response) {
  response.map = publishers_->last()->grid;
  return true;
}

bool MappingNodelet::reset(std_srvs::Trigger::Response& response) {
  try {
    response.success = startAnew() ? 1 : 0;
  } catch (const std::exception& error) {
    response.message =
        "the readings are deleted, but the empty map has to wait: " + reasonOf(error);
  }
  return true;
}

bool MappingNodelet::startAnew() {
  // The mapping thread may be inferring a map of the old readings. It does not publish that map.
  const std::lock_guard<std::mutex> lock(publishing_);
  {
    const std::lock_guard<std::mutex> locating(locating_);
    mapper_->reset();
    queue_->clear();
    refresh_rule_->clear();
    pose_watch_->clear();
    transform_watch_.clear();
    floors_.clear();
  }
  if (localisation_) {
    localisation_->forget();
  }
  clear_reported_ = true;
  forget_directories_ = true;
  announcements_.clear();
  try {
    const std::shared_ptr<const Snapshot> empty = mapper_->corrected({}).mapper.infer(stop_);
    if (empty) {
      publishers_->publish(empty, {}, MapPublishers::When::kAlways);
    }
    return empty != nullptr;
  } catch (...) {
    changed_ = true;
    throw;
  }
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

bool MappingNodelet::pause(const std_srvs::SetBool::Request& request,
                           std_srvs::SetBool::Response& response) {
  paused_ = request.data != 0;
  response.success = 1;
  response.message = paused_ ? "readings and contacts are dropped until ~pause is called with false"
                             : "readings and contacts are used";
  NODELET_INFO_STREAM("Pause: " << response.message);
  return true;
}

bool MappingNodelet::clearRegion(const structure_from_wifi::ClearRegion::Request& request,
                                 structure_from_wifi::ClearRegion::Response& response) {
  std::vector<Position> polygon;
  bool finite = std::isfinite(request.centre.x + request.centre.y + request.radius);
  for (const geometry_msgs::Point& corner : request.polygon) {
    polygon.emplace_back(corner.x, corner.y);
    finite = finite && polygon.back().allFinite();
  }
  if (!finite || (polygon.empty() ? request.radius <= 0.0 : polygon.size() < 3)) {
    response.message = "polygon must have at least 3 finite corners, or radius must be above 0";
    return true;
  }
  const Position centre(request.centre.x, request.centre.y);
  locateObservations();
  const auto [readings, contacts] = mapper_->forget([&](const Position& point) {
    return polygon.empty() ? (point - centre).norm() <= request.radius : contains(polygon, point);
  });
  refreshWhollyAnew();
  response.success = 1;
  response.readings = static_cast<std::uint32_t>(readings);
  response.contacts = static_cast<std::uint32_t>(contacts);
  response.message = std::to_string(readings) + " readings and " + std::to_string(contacts) +
                     " contacts are forgotten";
  return true;
}

void MappingNodelet::refreshWhollyAnew() {
  const std::lock_guard<std::mutex> lock(locating_);
  refresh_rule_->clear();
  changed_ = true;
  unsaved_ = true;
}

void MappingNodelet::placeAccessPoint(const geometry_msgs::PointStamped& click) {
  std::string text;
  getPrivateNodeHandle().getParam("clicked_point_bssid", text);
  const std::optional<Bssid> bssid = Bssid::parse(text);
  if (!bssid) {
    NODELET_WARN_STREAM("clicked_point is ignored: "
                        << getPrivateNodeHandle().getNamespace()
                        << "/clicked_point_bssid must name the access point, as "
                           "\"02:00:00:00:00:01\"; it is '"
                        << text << "'");
    return;
  }
  try {
    const geometry_msgs::Transform map_from_click =
        transforms_
            ->lookupTransform(ros_settings_.map_frame, withoutSlash(click.header.frame_id),
                              ros::Time())
            .transform;
    const Position position = inMap(map_from_click, click.point);
    mapper_->place(*bssid, position);
    refreshWhollyAnew();
    NODELET_INFO_STREAM("Access point " << bssid->str() << " stands at (" << position.x() << ", "
                                        << position.y() << ") now, as clicked");
  } catch (const std::exception& error) {
    NODELET_WARN_STREAM("clicked_point is ignored: " << reasonOf(error));
  }
}

}  // namespace sfw
