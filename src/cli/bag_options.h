#pragma once

#include <string>
#include <vector>

#include "cli/options.h"
#include "ros/bags/bag_reader.h"
#include "ros/conversion/ros_settings.h"

namespace sfw {

/// The options of `sfw map` for bags.
struct BagOptions {
  BagSource source;
  BagTopics topics = defaultBagTopics();
  std::string map_frame;
  std::vector<std::string> antenna_frames;  ///< several of several robots
  std::string odom_frame;

  /// Declares the options with their help.
  void declare(Options& options);

  /// The settings with the frames that the options give.
  RosSettings applied(RosSettings settings) const;
};

/// Inserts readings, contacts and path of bags into a mapper, and warns of those left out.
/// @throw as readBags
void insertBags(const BagOptions& options, const MappingSettings& settings, Mapper& mapper);

}  // namespace sfw
