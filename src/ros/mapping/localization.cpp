#include "ros/mapping/localization.h"

#include <cmath>
#include <cstdint>
#include <exception>
#include <variant>

#include "ros/mapping/odometry_frame.h"

namespace sfw {
namespace {

Eigen::Vector3d toVector(const geometry_msgs::Vector3& v) { return {v.x, v.y, v.z}; }

Eigen::Quaterniond toQuaternion(const geometry_msgs::Quaternion& q) {
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z);
}

/// The antenna and the odometry at a time, if tf has both.
std::optional<OdometryCorrection> correctionAt(const ros::Time& stamp, const RosSettings& config,
                                               const tf2::BufferCore& transforms) {
  const std::string odom_frame = odometryFrame(config, transforms);
  if (odom_frame.empty() || stamp.isZero() ||
      !transforms.canTransform(config.map_frame, odom_frame, stamp) ||
      !transforms.canTransform(config.map_frame, config.antenna_frame, stamp)) {
    return std::nullopt;
  }
  const auto lookup = [&](const std::string& frame) {
    return transforms.lookupTransform(config.map_frame, frame, stamp).transform;
  };
  const geometry_msgs::Transform map_from_odom = lookup(odom_frame);
  return OdometryCorrection{static_cast<std::int64_t>(stamp.toNSec()),
                            toVector(lookup(config.antenna_frame).translation).head<2>(),
                            toVector(map_from_odom.translation).head<2>(),
                            yawOf(map_from_odom.rotation)};
}

LocatedObservation locatedAt(const geometry_msgs::Transform& map_from_sensor,
                             const Observation& observation) {
  const auto stamp_ns = static_cast<std::int64_t>(observation.stamp.toNSec());
  const Eigen::Vector3d sensor_in_map = toVector(map_from_sensor.translation);
  const Eigen::Quaterniond turn = toQuaternion(map_from_sensor.rotation);
  LocatedObservation located;
  located.sensor_height_m = sensor_in_map.z();
  located.up_in_sensor = turn.conjugate() * Eigen::Vector3d::UnitZ();
  if (const auto* reading = std::get_if<UnlocatedReading>(&observation.content)) {
    located.readings = {{stamp_ns, sensor_in_map.head<2>(), reading->bssid, reading->rssi_dbm}};
    return located;
  }
  for (const Eigen::Vector3d& point : std::get<UnlocatedContacts>(observation.content).points) {
    const Eigen::Vector3d in_map = turn * point + sensor_in_map;
    located.contacts.push_back({stamp_ns, in_map.head<2>()});
  }
  return located;
}

}  // namespace

std::optional<LocatedObservation> locate(const Observation& observation, const RosSettings& config,
                                         const tf2::BufferCore& transforms, std::string& tf_error) {
  const auto* contacts = std::get_if<UnlocatedContacts>(&observation.content);
  const std::string frame =
      contacts != nullptr ? withoutSlash(contacts->frame) : config.antenna_frame;
  try {
    LocatedObservation located =
        locatedAt(transforms.lookupTransform(config.map_frame, frame, observation.stamp).transform,
                  observation);
    located.correction = correctionAt(observation.stamp, config, transforms);
    return located;
  } catch (const std::exception& error) {
    // Catches more than tf2's exceptions. tf2 subtracts stamps, and ros::Duration throws if they
    // are 68 years apart.
    tf_error = error.what();
    return std::nullopt;
  }
}

std::optional<LocatedPose> locatePose(const ros::Time& stamp, const RosSettings& config,
                                      const tf2::BufferCore& transforms) {
  try {
    if (!transforms.canTransform(config.map_frame, config.antenna_frame, stamp)) {
      return std::nullopt;
    }
    const geometry_msgs::Vector3 position =
        transforms.lookupTransform(config.map_frame, config.antenna_frame, stamp)
            .transform.translation;
    const PathPose pose{static_cast<std::int64_t>(stamp.toNSec()), {position.x, position.y}};
    LocatedPose located{pose, correctionAt(stamp, config, transforms)};
    if (located.correction) {
      located.correction->is_between = true;
    }
    return located;
  } catch (const std::exception&) {
    return std::nullopt;  // as in locate()
  }
}

std::optional<OdometryCorrection> latestCorrection(const RosSettings& config,
                                                   const tf2::BufferCore& transforms) {
  try {
    if (!transforms.canTransform(config.map_frame, config.antenna_frame, ros::Time())) {
      return std::nullopt;
    }
    const ros::Time latest =
        transforms.lookupTransform(config.map_frame, config.antenna_frame, ros::Time())
            .header.stamp;
    return correctionAt(latest, config, transforms);
  } catch (const std::exception&) {
    return std::nullopt;  // the buffer changed between two look-ups
  }
}

double yawOf(const geometry_msgs::Quaternion& q) {
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
}

Position inMap(const geometry_msgs::Transform& map_from_frame, const geometry_msgs::Point& point) {
  const Eigen::Vector3d in_frame(point.x, point.y, point.z);
  return (toQuaternion(map_from_frame.rotation) * in_frame + toVector(map_from_frame.translation))
      .head<2>();
}

PathCorrector::Tolerance jumpTolerance(const RosSettings& config) {
  return {config.jump_distance_m, config.jump_angle_rad};
}

}  // namespace sfw
