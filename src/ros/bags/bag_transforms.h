#pragma once

#include <tf2/buffer_core.h>

#include <cstddef>
#include <string>
#include <vector>

#include "ros/bags/bag_files.h"
#include "ros/bags/transform_times.h"
#include "ros/mapping/transform_watch.h"

namespace sfw {

/// Finds the topic of moving transforms: `tf` of the robot that has the scans.
///
/// That is the topic `tf` in the namespace of a scan or above it, or the only one there is.
/// @param topics       of all messages, without a leading slash
/// @param scan_topics  of those that bring readings, without a leading slash
/// @param given        by the user; empty: to be found
/// @return without a leading slash
/// @throw InputError in words that follow the name of the bag: there is none, or several.
std::string findTransformTopic(const std::vector<std::string>& topics,
                               const std::vector<std::string>& scan_topics,
                               const std::string& given);

/// What loadTransforms finds besides tf's tree.
struct LoadedTransforms {
  TransformTimes times;
  std::size_t infinite = 0;  ///< transforms that are not used, as by takeTransform
};

/// Loads the transforms of a topic and of its static ones, in the order received.
LoadedTransforms loadTransforms(const BagFiles& bags, const std::string& topic,
                                tf2::BufferCore& transforms, TransformWatch& watch);

}  // namespace sfw
