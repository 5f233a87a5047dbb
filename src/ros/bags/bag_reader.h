#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "ros/conversion/ros_settings.h"
#include "structure_from_wifi/mapper.h"

namespace sfw {

/// The topic name of each input in a bag (kInputs).
using BagTopics = std::map<std::string, std::string>;

/// The inputs of bags, each under its name in the nodelet.
BagTopics defaultBagTopics();

/// Counts the observations of a bag.
struct BagReading {
  std::size_t observations = 0;                 ///< readings and contacts found
  std::size_t unlocated = 0;                    ///< of these, those without a transform
  std::string tf_error;                         ///< of the last one without a transform
  std::map<std::string, std::size_t> rejected;  ///< readings and clouds left out, by problem
  std::map<std::string, std::string> problems;  ///< the last one of each topic of a radio
};

/// Inserts the readings and contacts of a bag into a mapper. The bag's tf is read first, so the
/// order of recording does not matter.
/// @throw InputError naming the file if it cannot be read or has no reading.
BagReading readBag(const std::string& file, const BagTopics& topics,
                   const MappingSettings& settings, Mapper& mapper);

}  // namespace sfw
