#pragma once

#include <string>
#include <vector>

namespace sfw {

/// Whether this nodelet publishes the topic already.
enum class Advertised { kNo, kYes };

/// The nodes that publish a topic besides this nodelet; its own node is one of them if another
/// nodelet of the process does. Asks the ROS master, so it is for the start only; without an
/// answer there are none.
/// @param topic  its full name
std::vector<std::string> otherPublishers(const std::string& topic, Advertised advertised);

}  // namespace sfw
