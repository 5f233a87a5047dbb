#pragma once

#include <cstddef>
#include <string>

#include "structure_from_wifi/config.h"
#include "structure_from_wifi/mapper.h"

namespace sfw {

/// Names of the topics in a bag, as recorded.
struct BagTopics {
  std::string wifi_scan = "/wifi_scan";
  std::string connection = "/connection";
  std::string contact_points = "/contact_points";
};

/// What came out of a bag.
struct BagReading {
  std::size_t observations = 0;  ///< readings and contacts found
  std::size_t unplaced = 0;      ///< of these, those without a transform at their stamp
  std::size_t malformed = 0;     ///< readings and clouds of contacts left out before
  std::string reason;            ///< tf's words for the last one without a transform
};

/// Puts the readings and contacts of a bag into a mapper, placed by the bag's own tf, read whole
/// first: the result does not depend on the order in which messages were recorded.
/// @throw InputError naming the file if it cannot be read or has none of the topics.
BagReading readBag(const std::string& file, const BagTopics& topics, const Config::Ros& config,
                   Mapper& mapper);

}  // namespace sfw
