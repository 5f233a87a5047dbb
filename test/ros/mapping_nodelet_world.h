#pragma once

#include <gtest/gtest.h>
#include <nodelet/loader.h>
#include <ros/ros.h>
#include <structure_from_wifi/SaveMap.h>
#include <structure_from_wifi/WifiScan.h>
#include <tf2_msgs/TFMessage.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "ros/service_call.h"
#include "strict_consumers.h"
#include "support/slowdown.h"

namespace sfw {

/// Handles messages until something becomes true or real time runs out.
inline bool spinUntil(const std::function<bool()>& done, double timeout_s) {
  const ros::SteadyTime deadline = ros::SteadyTime::now() + ros::WallDuration(timeout_s);
  while (!done() && ros::SteadyTime::now() < deadline) {
    ros::spinOnce();
    ros::WallDuration(0.002).sleep();
  }
  return done();
}

/// A mapping nodelet with its clock, transforms, scans and saved files; one world a test, each in
/// a namespace and a stretch of time of its own.
class NodeletWorld : public testing::Test {
 protected:
  static constexpr char kNear[] = "02:00:00:00:00:01";
  static constexpr char kFar[] = "02:00:00:00:00:02";
  using Readings = std::vector<std::pair<std::string, float>>;

  void SetUp() override {
    static int worlds = 0;
    name_ = "/world" + std::to_string(++worlds);
    start_ = ros::Time(10000.0 * worlds);  // no jump back from test to test
    ros::Time::setNow(start_);
    folder_ = std::filesystem::temp_directory_path() /
              ("sfw_nodelet_" + std::to_string(getpid()) + "_" + std::to_string(worlds));
    const std::string parameters = name_ + "/mapping";
    ros::param::set(parameters + "/access_points", tableOf({{kNear, 0.5, 0.5}, {kFar, 4.0, 3.0}}));
    ros::param::set(parameters + "/ros/save_directory", folder_.string());
    ros::param::set(parameters + "/ros/publish_rate", 20.0);
    ros::param::set(parameters + "/ros/cpu_share", 1.0);
    ros::NodeHandle node;
    transforms_ = node.advertise<tf2_msgs::TFMessage>("/tf", 1000);
    scans_ = node.advertise<structure_from_wifi::WifiScan>(name_ + "/wifi_scan", 10000);
    map_subscriber_ = node.subscribe<nav_msgs::OccupancyGrid>(
        name_ + "/map", 100, [this](const nav_msgs::OccupancyGridConstPtr& map) { map_ = map; });
  }

  void TearDown() override {
    loader_.clear();
    // A callback may hold the nodelet, which saves its session when it ends.
    spinUntil([&] { return !advertises(name_ + "/map"); }, 10.0 * kSlowdown);
    consumers_.reset();
    ros::param::del(name_);
    std::filesystem::remove_all(folder_);
  }

  /// Loads the nodelet and waits until it hears scans and transforms.
  void load() {
    consumers_.emplace(ros::NodeHandle(name_));  // a new nodelet may begin with another geometry
    ASSERT_TRUE(loader_.load(name_ + "/mapping", "structure_from_wifi/MappingNodelet", {}, {}));
    ASSERT_TRUE(spinUntil(
        [&] { return transforms_.getNumSubscribers() > 0 && scans_.getNumSubscribers() > 0; },
        5.0));
  }

  double secondsToUnload() {
    const ros::SteadyTime start = ros::SteadyTime::now();
    EXPECT_TRUE(loader_.unload(name_ + "/mapping"));
    const double seconds = (ros::SteadyTime::now() - start).toSec();
    // Until the connections are gone as well, a next load() would take them for its own.
    spinUntil(
        [&] { return transforms_.getNumSubscribers() == 0 && scans_.getNumSubscribers() == 0; },
        2.0);
    return seconds;
  }

  ros::Time at(double seconds) const { return start_ + ros::Duration(seconds); }

  /// A transform without a turn.
  geometry_msgs::TransformStamped transform(double seconds, const std::string& parent,
                                            const std::string& child, double x, double y) const {
    geometry_msgs::TransformStamped transform;
    transform.header.stamp = at(seconds);
    transform.header.frame_id = parent;
    transform.child_frame_id = child;
    transform.transform.translation.x = x;
    transform.transform.translation.y = y;
    transform.transform.rotation.w = 1.0;
    return transform;
  }

  void sendPose(double seconds, double x, double y) {
    tf2_msgs::TFMessage message;
    message.transforms = {transform(seconds, "map", "base_link", x, y)};
    transforms_.publish(message);
  }

  static structure_from_wifi::WifiScan scanOf(const Readings& readings, float age_s = 0.0F) {
    structure_from_wifi::WifiScan scan;
    for (const auto& [bssid, rssi_dbm] : readings) {
      structure_from_wifi::ApReading reading;
      reading.bssid = bssid;
      reading.ssid.assign(32, '\0');  // any bytes are a name
      reading.rssi_dbm = rssi_dbm;
      reading.age_s = age_s;
      scan.readings.push_back(reading);
    }
    return scan;
  }

  void sendScan(double seconds, const Readings& readings, float age_s = 0.0F) {
    structure_from_wifi::WifiScan scan = scanOf(readings, age_s);
    scan.header.stamp = at(seconds);
    scans_.publish(scan);
  }

  /// A table of access points as the parameter server holds it.
  static XmlRpc::XmlRpcValue tableOf(
      const std::vector<std::tuple<std::string, double, double>>& access_points) {
    XmlRpc::XmlRpcValue table;
    for (std::size_t i = 0; i < access_points.size(); ++i) {
      XmlRpc::XmlRpcValue& entry = table[static_cast<int>(i)];
      entry["bssid"] = std::get<0>(access_points[i]);
      entry["x"] = std::get<1>(access_points[i]);
      entry["y"] = std::get<2>(access_points[i]);
    }
    return table;
  }

  /// The rows that the nodelet saves, once there are so many; the present ones after 30 s.
  std::vector<std::string> rows(std::size_t expected) {
    std::vector<std::string> saved;
    spinUntil([&] { return (saved = savedRows()).size() >= expected; }, 30.0 * kSlowdown);
    return saved;
  }

  /// A reading as readings.csv holds it, in numbers of fixed form so that rows compare.
  std::string row(double seconds, double x, double y, const std::string& bssid,
                  double rssi_dbm) const {
    return formatted(at(seconds).toSec(), x, y, bssid, rssi_dbm);
  }

  structure_from_wifi::SaveMap::Response save(const std::string& directory) {
    structure_from_wifi::SaveMap save;
    save.request.directory = directory;
    EXPECT_TRUE(callService(name_ + "/mapping/save_map", save));
    return save.response;
  }

  /// The content of a saved file; empty while there are no readings.
  std::string savedFile(const std::string& file) {
    const structure_from_wifi::SaveMap::Response response = save("saved");
    EXPECT_TRUE(response.success || response.message.find("no readings") != std::string::npos)
        << response.message;
    std::ifstream stream(std::filesystem::path(response.message) / file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  static bool advertises(const std::string& topic) {
    ros::V_string topics;
    ros::this_node::getAdvertisedTopics(topics);
    return std::find(topics.begin(), topics.end(), topic) != topics.end();
  }

  std::string name_;
  ros::Time start_;
  std::filesystem::path folder_;
  nodelet::Loader loader_{false};
  ros::Publisher transforms_, scans_;
  ros::Subscriber map_subscriber_;
  nav_msgs::OccupancyGridConstPtr map_;
  std::optional<StrictConsumers> consumers_;  // of all that the nodelet publishes

 private:
  static std::string formatted(double stamp, double x, double y, const std::string& bssid,
                               double rssi_dbm) {
    char text[128];
    std::snprintf(text, sizeof(text), "%.3f %.4f %.4f %s %.2f", stamp, x, y, bssid.c_str(),
                  rssi_dbm);
    return text;
  }

  std::vector<std::string> savedRows() {
    std::istringstream file(savedFile("readings.csv"));
    std::vector<std::string> rows;
    std::string line;
    std::getline(file, line);
    EXPECT_EQ(line, line.empty() ? "" : "stamp,x,y,bssid,rssi_dbm");
    while (std::getline(file, line)) {
      std::replace(line.begin(), line.end(), ',', ' ');
      std::istringstream fields(line);
      double stamp = 0.0, x = 0.0, y = 0.0, rssi_dbm = 0.0;
      std::string bssid;
      fields >> stamp >> x >> y >> bssid >> rssi_dbm;
      EXPECT_TRUE(fields) << line;
      rows.push_back(formatted(stamp, x, y, bssid, rssi_dbm));
    }
    return rows;
  }
};

}  // namespace sfw
