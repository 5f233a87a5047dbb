#pragma once

#include <yaml-cpp/yaml.h>

#include "structure_from_wifi/access_points_io.h"

namespace sfw {

/// Reads the table of access points from the parameters of a node: from the file that
/// `access_points_file` names, or from the list `access_points`.
///
/// The file is safer: rosparam turns some BSSIDs without quotes into numbers. If both are set, the
/// file wins, and a warning says so.
/// @throw InputError as readAccessPoints and accessPointsFromYaml
AccessPointReading accessPointsOfParameters(const YAML::Node& parameters);

}  // namespace sfw
