#pragma once

#include <string>
#include <vector>

namespace sfw {

/// Replaces each directory by the HouseExpo and map_server files in it, sorted by name.
std::vector<std::string> floorPlanFiles(const std::vector<std::string>& names);

}  // namespace sfw
