#include "ros/conversion/cloud_points.h"

#include <sensor_msgs/PointField.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <string>

namespace sfw {
namespace {

/// Where a coordinate stands in each point [bytes].
std::size_t offsetOf(const sensor_msgs::PointCloud2& cloud, const char* name) {
  const auto field =
      std::find_if(cloud.fields.begin(), cloud.fields.end(),
                   [&](const sensor_msgs::PointField& one) { return one.name == name; });
  if (field == cloud.fields.end()) {
    throw std::runtime_error("it has no field " + std::string(name));
  }
  if (field->datatype != sensor_msgs::PointField::FLOAT32) {
    throw std::runtime_error("its field " + field->name + " is not of the type FLOAT32");
  }
  if (std::size_t{field->offset} + sizeof(float) > cloud.point_step) {
    throw std::runtime_error("its field " + field->name + " reaches beyond point_step");
  }
  return field->offset;
}

float coordinateAt(const std::uint8_t* bytes) {
  float coordinate = 0.0F;
  std::memcpy(&coordinate, bytes, sizeof coordinate);  // it may stand at any address
  return coordinate;
}

}  // namespace

std::vector<Eigen::Vector3d> nearPoints(const sensor_msgs::PointCloud2& cloud, double farthest_m) {
  const std::array<std::size_t, 3> offsets{offsetOf(cloud, "x"), offsetOf(cloud, "y"),
                                           offsetOf(cloud, "z")};
  if (cloud.is_bigendian != 0) {
    throw std::runtime_error("its numbers are big-endian");
  }
  const std::size_t count = std::size_t{cloud.width} * cloud.height;
  if (count > cloud.data.size() / cloud.point_step) {  // a product of all three would overflow
    throw std::runtime_error("it has less data than width, height and point_step say");
  }
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* bytes = cloud.data.data() + i * cloud.point_step;
    const Eigen::Vector3d point(coordinateAt(bytes + offsets[0]), coordinateAt(bytes + offsets[1]),
                                coordinateAt(bytes + offsets[2]));
    if (point.allFinite() && point.norm() <= farthest_m) {
      points.push_back(point);
    }
  }
  return points;
}

}  // namespace sfw
