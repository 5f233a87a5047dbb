#include "ros/conversion/access_point_parameters.h"

#include <string>

#include "files/yaml.h"

namespace sfw {

AccessPointReading accessPointsOfParameters(const YAML::Node& parameters) {
  if (!parameters.IsMap() || !parameters["access_points_file"]) {
    return accessPointsFromYaml(parameters.IsMap() ? parameters["access_points"] : YAML::Node());
  }
  std::string file;
  if (!readScalar(parameters["access_points_file"], file) || file.empty()) {
    throw InputError("access_points_file must be the path of a file");
  }
  AccessPointReading reading = readAccessPoints(file);
  for (std::string& warning : reading.warnings) {
    warning = "access_points_file: " + file + ": " + warning;
  }
  if (parameters["access_points"]) {
    reading.warnings.push_back(
        "access_points is not read, since access_points_file is set: " + file + " wins");
  }
  return reading;
}

}  // namespace sfw
