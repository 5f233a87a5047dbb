#include "ros/conversion/parameters.h"

#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

std::string toText(double value) {
  if (!std::isfinite(value)) {
    return std::isnan(value) ? ".nan" : value > 0.0 ? ".inf" : "-.inf";
  }
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(std::numeric_limits<double>::max_digits10);
  text << value;
  return text.str();
}

YAML::Node arrayToYaml(const XmlRpc::XmlRpcValue& value, const std::string& name) {
  YAML::Node node(YAML::NodeType::Sequence);
  for (int i = 0; i < value.size(); ++i) {
    node.push_back(toYaml(value[i], name + "[" + std::to_string(i) + "]"));
  }
  return node;
}

YAML::Node structToYaml(const XmlRpc::XmlRpcValue& value, const std::string& name) {
  YAML::Node node(YAML::NodeType::Map);
  for (const auto& [key, member] : value) {
    node[key] = toYaml(member, name.empty() ? key : name + "/" + key);
  }
  return node;
}

}  // namespace

YAML::Node toYaml(const XmlRpc::XmlRpcValue& value, const std::string& name) {
  switch (value.getType()) {
    case XmlRpc::XmlRpcValue::TypeInvalid:
      return YAML::Node();
    case XmlRpc::XmlRpcValue::TypeBoolean:
      return YAML::Node(static_cast<const bool&>(value));
    case XmlRpc::XmlRpcValue::TypeInt:
      return YAML::Node(static_cast<const int&>(value));
    case XmlRpc::XmlRpcValue::TypeDouble:
      return YAML::Node(toText(static_cast<const double&>(value)));
    case XmlRpc::XmlRpcValue::TypeString:
      return YAML::Node(static_cast<const std::string&>(value));
    case XmlRpc::XmlRpcValue::TypeArray:
      return arrayToYaml(value, name);
    case XmlRpc::XmlRpcValue::TypeStruct:
      return structToYaml(value, name);
    default:
      throw InputError(name + " must not be a date or binary");
  }
}

YAML::Node parametersOf(const ros::NodeHandle& node) {
  XmlRpc::XmlRpcValue tree;
  node.getParam(node.getNamespace(), tree);
  return toYaml(tree);
}

}  // namespace sfw
