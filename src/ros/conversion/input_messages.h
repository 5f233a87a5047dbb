#pragma once

#include <ros/time.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Bool.h>
#include <structure_from_wifi/WifiScan.h>
#include <wireless_msgs/Connection.h>

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// A signal strength at an unknown position.
struct UnlocatedReading {
  Bssid bssid;
  double rssi_dbm = 0.0;
};

/// Obstacles that the robot touched, in the frame of its sensor [m].
struct UnlocatedContacts {
  std::string frame;
  std::vector<Eigen::Vector3d> points;
};

/// A reading or contacts at a time, before tf gives their position.
struct Observation {
  ros::Time stamp;
  std::variant<UnlocatedReading, UnlocatedContacts> content;
};

/// The usable observations of a message, with the count and the problem of the others.
struct Conversion {
  std::vector<Observation> observations = {};
  std::size_t rejected = 0;  ///< readings or clouds left out
  std::string problem = {};  ///< of the message, in words; empty if there is none
};

/// The inputs of a conversion besides the message.
struct InputContext {
  ros::Time received;  ///< replaces a missing stamp
  std::string antenna_frame;
  double footprint_radius_m = 0.0;
};

/// Converts the readings of a scan. The time of each reading is the stamp minus its age.
Conversion convertScan(const structure_from_wifi::WifiScan& scan, const InputContext& context);

/// Converts the signal strength of a link, at the time of arrival. A radio that is not associated
/// has none.
Conversion convertConnection(const wireless_msgs::Connection& connection,
                             const InputContext& context);

/// Converts a bumper without direction to a contact ahead of the antenna, at the robot's rim.
Conversion convertContact(const std_msgs::Bool& contact, const InputContext& context);

/// Converts the points of a bumper's cloud within 2 m. Nodes with such clouds publish distant
/// points for bumpers that are not pressed.
Conversion convertContactPoints(const sensor_msgs::PointCloud2& cloud, const InputContext& context);

/// A type of input: its topic, message and conversion.
template <class MessageType>
struct Input {
  using Message = MessageType;

  const char* topic;       ///< of the nodelet; a bag has it under this name by default
  bool is_radio;           ///< it brings readings
  const char* bag_option;  ///< of `sfw map` for the topic in a bag; nullptr: not read from bags
  Conversion (*convert)(const Message&, const InputContext&);
};

/// Calls `visit(input)` for each type of input, live and in bags. A new type needs a row here and
/// its conversion above.
template <class Visitor>
void forEachInput(Visitor&& visit) {
  visit(Input<structure_from_wifi::WifiScan>{"wifi_scan", true, "scan-topic", convertScan});
  visit(
      Input<wireless_msgs::Connection>{"connection", true, "connection-topic", convertConnection});
  visit(Input<std_msgs::Bool>{"contact", false, nullptr, convertContact});
  visit(Input<sensor_msgs::PointCloud2>{"contact_points", false, "contact-topic",
                                        convertContactPoints});
}

}  // namespace sfw
