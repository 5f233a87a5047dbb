#pragma once

#include <ros/time.h>
#include <sensor_msgs/PointCloud2.h>
#include <structure_from_wifi/WifiScan.h>
#include <wireless_msgs/Connection.h>

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// One signal strength whose place is not known yet.
struct UnplacedReading {
  Bssid bssid;
  double rssi_dbm = 0.0;
};

/// Obstacles that the robot touched, in the frame of its sensor [m].
struct UnplacedContacts {
  std::string frame;
  std::vector<Eigen::Vector3d> points;
};

/// What was sensed at a time, before tf says where.
struct Observation {
  ros::Time stamp;
  std::variant<UnplacedReading, UnplacedContacts> content;
};

/// The readings of a scan, each at its own time: stamp minus age. Without a stamp, `now` counts.
/// @param malformed is raised by the readings whose bssid cannot be read and by all that a scan
/// has beyond 1000
std::vector<Observation> toObservations(const structure_from_wifi::WifiScan& scan,
                                        const ros::Time& now, std::size_t& malformed);

/// Where a bumper without direction is taken to be pressed: ahead of the antenna's frame.
Observation frontContact(const std::string& antenna_frame, double footprint_radius_m,
                         const ros::Time& now);

/// The points of a bumper's cloud. Such nodes put the bumpers that are not pressed far away, so
/// points beyond 2 m are left out, as are points that are not finite.
/// @throw std::runtime_error if the cloud has no x, y, z.
Observation toObservation(const sensor_msgs::PointCloud2& cloud, const ros::Time& now);

/// The link's signal strength; empty while the radio is not associated.
std::vector<Observation> toObservations(const wireless_msgs::Connection& connection,
                                        const ros::Time& now);

}  // namespace sfw
