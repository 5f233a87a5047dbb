#include "ros/conversion/access_point_parameters.h"

#include <string>

#include "files/text.h"
#include "files/yaml.h"

namespace sfw {

AccessPointReading accessPointsOfParameters(const YAML::Node& parameters) {
  const bool has_list = parameters.IsMap() && parameters["access_points"];
  if (!parameters.IsMap() || !parameters["access_points_file"]) {
    return has_list ? accessPointsFromYaml(parameters["access_points"]) : AccessPointReading{};
  }
  std::string file;
  if (!readScalar(parameters["access_points_file"], file) || file.empty()) {
    throw InputError("access_points_file must be the path of a file");
  }
  const std::string name = "access_points_file: ";
  AccessPointReading reading;
  try {
    reading = readAccessPoints(file);
  } catch (const InputError& error) {
    throw InputError(withPrefix(name, error.what()));
  }
  for (std::string& warning : reading.warnings) {
    warning = name + file + ": " + warning;
  }
  if (has_list) {
    reading.warnings.push_back(
        "access_points is not read, since access_points_file is set: " + file + " wins");
  }
  return reading;
}

}  // namespace sfw
