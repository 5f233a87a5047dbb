#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <Eigen/Core>
#include <vector>

namespace sfw {

/// The finite points of a cloud within a distance of its origin [m].
///
/// Nothing in the message is trusted: sensor_msgs' own iterators read beyond the end of a cloud
/// whose size does not match its data.
/// @throw std::runtime_error naming the fault of the cloud
std::vector<Eigen::Vector3d> nearPoints(const sensor_msgs::PointCloud2& cloud, double farthest_m);

}  // namespace sfw
