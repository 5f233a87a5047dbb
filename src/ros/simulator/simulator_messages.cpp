#include "ros/simulator/simulator_messages.h"

#include <sensor_msgs/point_cloud2_iterator.h>

#include <cmath>
#include <optional>

#include "base/constants.h"
#include "ros/conversion/message_conversion.h"

namespace sfw {

std_msgs::Bool boolMessage(bool value) {
  std_msgs::Bool message;
  message.data = value;
  return message;
}

std::vector<geometry_msgs::TransformStamped> transformMessages(const SimulatorConfig& config,
                                                               const PositionError& error,
                                                               const ros::Time& stamp,
                                                               const RobotPose& pose,
                                                               double driven_m) {
  const Position origin(config.odom.x_m, config.odom.y_m);
  const double yaw = config.odom.yaw_rad;
  const Position drifted = pose.position + error.drift(driven_m);
  const RobotPose odom_from_base{Eigen::Rotation2Dd(-yaw) * (drifted - origin), pose.yaw_rad - yaw};
  const RobotPose map_from_odom{origin + error.registration(pose.position), yaw};
  return {toPlanarTransform(stamp, config.map_frame, config.odom_frame, map_from_odom.position,
                            map_from_odom.yaw_rad),
          toPlanarTransform(stamp, config.odom_frame, config.base_frame, odom_from_base.position,
                            odom_from_base.yaw_rad)};
}

nav_msgs::Odometry odometryMessage(const geometry_msgs::TransformStamped& before,
                                   const geometry_msgs::TransformStamped& now) {
  nav_msgs::Odometry odometry;
  odometry.header = now.header;
  odometry.child_frame_id = now.child_frame_id;
  odometry.pose.pose.position.x = now.transform.translation.x;
  odometry.pose.pose.position.y = now.transform.translation.y;
  odometry.pose.pose.orientation = now.transform.rotation;
  const double seconds = (now.header.stamp - before.header.stamp).toSec();
  if (seconds > 0.0) {
    const auto yaw = [](const geometry_msgs::TransformStamped& message) {
      return 2.0 * std::atan2(message.transform.rotation.z, message.transform.rotation.w);
    };
    const Position step(now.transform.translation.x - before.transform.translation.x,
                        now.transform.translation.y - before.transform.translation.y);
    const double turn = std::remainder(yaw(now) - yaw(before), 2.0 * kPi);
    // On an arc the robot looks along the chord in its middle.
    const Position velocity = Eigen::Rotation2Dd(-(yaw(before) + 0.5 * turn)) * step / seconds;
    odometry.twist.twist.linear.x = velocity.x();
    odometry.twist.twist.linear.y = velocity.y();
    odometry.twist.twist.angular.z = turn / seconds;
  }
  return odometry;
}

sensor_msgs::PointCloud2 bumperCloud(const RobotPose& pose, const std::optional<Position>& point) {
  constexpr float kHeight = 0.05F;  // [m]
  sensor_msgs::PointCloud2 cloud;
  sensor_msgs::PointCloud2Modifier(cloud).setPointCloud2FieldsByString(1, "xyz");
  sensor_msgs::PointCloud2Modifier(cloud).resize(point ? 1 : 0);
  if (point) {
    const Position at = Eigen::Rotation2Dd(-pose.yaw_rad) * (*point - pose.position);
    sensor_msgs::PointCloud2Iterator<float> x(cloud, "x");
    x[0] = static_cast<float>(at.x());
    x[1] = static_cast<float>(at.y());
    x[2] = kHeight;
  }
  return cloud;
}

sensor_msgs::LaserScan laserMessage(const Grid<CellState>& plan, const RobotPose& pose,
                                    const LaserConfig& config) {
  sensor_msgs::LaserScan scan;
  const std::vector<double> ranges = laserRanges(plan, pose, config);
  scan.ranges.assign(ranges.begin(), ranges.end());
  scan.angle_min = static_cast<float>(beamBearing(config, 0));
  scan.angle_max = static_cast<float>(beamBearing(config, config.beams - 1));
  scan.angle_increment = static_cast<float>(2.0 * kPi / static_cast<double>(config.beams));
  scan.range_max = static_cast<float>(config.range_m);
  return scan;
}

structure_from_wifi::WifiScan scanMessage(const RadioModel& radio, const RobotPose& pose,
                                          std::uint64_t sample) {
  structure_from_wifi::WifiScan scan;
  for (std::size_t i = 0; i < radio.transmitters().size(); ++i) {
    const std::optional<double> rssi_dbm = radio.rssi(i, pose, sample);
    if (rssi_dbm) {
      const Transmitter& transmitter = radio.transmitters()[i];
      structure_from_wifi::ApReading reading;
      reading.bssid = transmitter.access_point.bssid.str();
      reading.ssid = transmitter.access_point.name;
      reading.rssi_dbm = static_cast<float>(*rssi_dbm);
      reading.frequency_mhz = static_cast<float>(frequencyMhz(transmitter.band));
      scan.readings.push_back(reading);
    }
  }
  return scan;
}

}  // namespace sfw
