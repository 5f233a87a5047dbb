#pragma once

#include <string>
#include <vector>

namespace sfw {

/// The name of each robot in topics: the shortest beginning of its antenna frame, in whole parts,
/// that no other frame has. `robot1/base_link` and `robot2/base_link` are of `robot1` and `robot2`.
/// What names of topics may not have becomes '_'.
/// @param antenna_frames  of all robots, without leading slashes
std::vector<std::string> robotNames(const std::vector<std::string>& antenna_frames);

/// The antenna frame of the robot in whose namespace a topic lies; empty if in none. The namespace
/// may lie in another one: `/fleet/robot1/contact` is of `robot1`.
/// @param antenna_frames  of all robots; one alone has every topic
std::string robotOfTopic(const std::string& topic, const std::vector<std::string>& antenna_frames);

}  // namespace sfw
