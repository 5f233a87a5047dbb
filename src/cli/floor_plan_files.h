#pragma once

#include <string>
#include <vector>

namespace sfw {

/// Names of plans with each directory replaced by the HouseExpo and map_server files in it, sorted.
std::vector<std::string> floorPlanFiles(const std::vector<std::string>& names);

}  // namespace sfw
