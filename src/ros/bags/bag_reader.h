#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "ros/conversion/ros_settings.h"
#include "structure_from_wifi/mapper.h"

namespace sfw {

/// The topic names of each input in a bag (kInputs); several robots may have one each.
using BagTopics = std::map<std::string, std::vector<std::string>>;

/// The inputs of bags, each under its name in the nodelet.
BagTopics defaultBagTopics();

/// The bags of a recording.
struct BagSource {
  std::vector<std::string> files;  ///< in any order
  std::string tf_topic;            ///< of the transforms; empty: findTransformTopic
};

/// The readings and contacts of a robot without a transform.
struct UnlocatedCount {
  std::string antenna_frame;
  std::size_t before_transforms = 0;  ///< those before the first transform
  std::size_t after_transforms = 0;   ///< those after the last transform
  double transforms_from_s = 0.0;     ///< first transform, after the bags' begin
  double transforms_until_s = 0.0;    ///< last transform, likewise
  std::size_t others = 0;             ///< those without a transform for another reason
  std::string tf_error;               ///< of the last one of these
  bool are_frames_connected = false;  ///< antenna and map, at some time
};

/// Counts the observations of bags.
struct BagReading {
  std::size_t observations = 0;                 ///< readings and contacts found
  std::vector<UnlocatedCount> unlocated;        ///< of each robot (antennaFrames)
  std::size_t infinite_transforms = 0;          ///< which are not used
  std::vector<std::string> frames;              ///< all frames of the transforms
  std::string odom_frame;                       ///< of the first robot, as odometryFrame finds it
  std::map<std::string, std::size_t> rejected;  ///< readings and clouds left out, by problem
  std::map<std::string, std::string> problems;  ///< the last one of each topic of a radio
};

/// Names bags in a message: the first one, and how many more there are.
std::string namesOf(const std::vector<std::string>& files);

/// Inserts readings, contacts and the path between readings into a mapper. All transforms are read
/// first, so the order of recording does not matter, nor which bag has the static ones.
/// @throw InputError naming the file if it cannot be read, or the first file if there is no reading
/// or no transform.
BagReading readBags(const BagSource& source, const BagTopics& topics,
                    const MappingSettings& settings, Mapper& mapper);

}  // namespace sfw
