#include "files/yaml.h"

#include <cmath>

#include "files/text.h"

namespace sfw {

bool readScalar(const YAML::Node& node, bool& value) {
  return YAML::convert<bool>::decode(node, value);
}

bool readScalar(const YAML::Node& node, double& value) {
  const auto number = node.IsScalar() ? parseNumber(node.Scalar()) : std::nullopt;
  value = number.value_or(value);
  return number.has_value();
}

bool readScalar(const YAML::Node& node, std::int64_t& value) {
  double number = 0.0;
  if (!readScalar(node, number) || number != std::floor(number) || std::abs(number) > 1e15) {
    return false;
  }
  value = static_cast<std::int64_t>(number);
  return true;
}

bool readScalar(const YAML::Node& node, std::string& value) {
  if (!node.IsScalar()) {
    return false;
  }
  value = node.Scalar();
  return true;
}

const char* typeName(bool /*value*/) { return "true or false"; }
const char* typeName(double /*value*/) { return "a number"; }
const char* typeName(std::int64_t /*value*/) { return "a whole number"; }
const char* typeName(const std::string& /*value*/) { return "a text"; }

std::string foundText(const YAML::Node& node) {
  if (node.IsScalar()) {
    return inQuotes(node.Scalar());
  }
  return node.IsSequence() ? "a list" : node.IsMap() ? "a group" : "empty";
}

YAML::Node loadYaml(const std::string& file) {
  try {
    return YAML::Load(readFile(file));
  } catch (const YAML::Exception& error) {
    throw InputError(file + ": line " + std::to_string(error.mark.line + 1) + ": " + error.msg);
  }
}

}  // namespace sfw
