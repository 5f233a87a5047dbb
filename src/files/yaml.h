#pragma once

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <string>

#include "structure_from_wifi/input_error.h"

namespace sfw {

/// Reads a scalar as the type of `value`. A text is not a number, and 2.5 is not a whole number.
/// @return whether the node has that type; if not, `value` stays as it is.
bool readScalar(const YAML::Node& node, bool& value);
bool readScalar(const YAML::Node& node, double& value);
bool readScalar(const YAML::Node& node, std::int64_t& value);
bool readScalar(const YAML::Node& node, std::string& value);

/// The type of a value, as errors name it: "a whole number".
const char* typeName(bool value);
const char* typeName(double value);
const char* typeName(std::int64_t value);
const char* typeName(const std::string& value);

/// What stands where a value of another type is expected, as errors name it: "'fast'", "a list".
std::string foundText(const YAML::Node& node);

/// The content of a YAML file.
/// @throw InputError naming the file, and the line of an error in it.
YAML::Node loadYaml(const std::string& file);

/// Loads a YAML file and reads its content. The errors of `read` get the name of the file.
template <class Read>
auto readYaml(const std::string& file, Read&& read) {
  const YAML::Node node = loadYaml(file);
  try {
    return read(node);
  } catch (const InputError& error) {
    throw InputError(file + ": " + error.what());
  }
}

}  // namespace sfw
