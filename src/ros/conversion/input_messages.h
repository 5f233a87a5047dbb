#pragma once

#include <ros/time.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Bool.h>

#include <array>
#include <string>
#include <vector>

#include "ros/conversion/any_message.h"
#include "ros/conversion/observation.h"
#include "ros/conversion/scan_format.h"

namespace sfw {

/// The inputs of a conversion besides the message.
struct InputContext {
  ros::Time received;  ///< replaces a missing stamp
  /// Of the robot that has the topic. Empty: the topic is that of several robots.
  std::string antenna_frame;
  double footprint_radius_m = 0.0;
  ScanFormat scan_format = {};                   ///< of the settings
  std::vector<std::string> antenna_frames = {};  ///< of all robots, if there are several
};

/// Converts a bumper without direction to a contact ahead of the antenna, at the robot's rim. On a
/// topic of several robots it is rejected, because it does not name its robot.
Conversion convertContact(const std_msgs::Bool& contact, const InputContext& context);

/// Converts the points of a bumper's cloud within 2 m. Nodes with such clouds publish distant
/// points for bumpers that are not pressed.
Conversion convertContactPoints(const sensor_msgs::PointCloud2& cloud, const InputContext& context);

/// Names the robot of a scan: the one whose antenna frame is that of the scan, or else the one that
/// has the topic. If there is none, all readings are rejected. One robot alone has no name.
Conversion withRobot(Conversion conversion, const InputContext& context);

/// Convert a message of any type. One of a type that they cannot read is rejected, and the problem
/// names its type. They never throw.
/// @{
Conversion convertReadings(const AnyMessage& message, const InputContext& context);
Conversion convertAnyContact(const AnyMessage& message, const InputContext& context);
Conversion convertAnyContactPoints(const AnyMessage& message, const InputContext& context);
/// @}

/// An input: its topic, and the conversion of its messages.
struct Input {
  const char* topic;       ///< of the nodelet; a bag has it under this name by default
  bool is_radio;           ///< it brings readings
  const char* bag_option;  ///< of `sfw map` for the topic in a bag
  const char* meaning;     ///< of the topic, for `sfw map --help`
  Conversion (*convert)(const AnyMessage&, const InputContext&);
};

/// All inputs, live and in bags.
inline constexpr std::array<Input, 4> kInputs{{
    {"wifi_scan", true, "scan-topic", "topic of scans in the bag", convertReadings},
    {"connection", true, "connection-topic", "topic of the associated link in the bag",
     convertReadings},
    {"contact", false, "bumper-topic", "topic of std_msgs/Bool in the bag", convertAnyContact},
    {"contact_points", false, "contact-topic", "topic of sensor_msgs/PointCloud2 in the bag",
     convertAnyContactPoints},
}};

}  // namespace sfw
