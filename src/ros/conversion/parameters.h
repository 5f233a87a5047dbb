#pragma once

#include <ros/node_handle.h>
#include <xmlrpcpp/XmlRpcValue.h>
#include <yaml-cpp/yaml.h>

#include <string>

namespace sfw {

/// Converts a tree of ROS parameters to YAML, so that one reader serves files and parameters.
/// Numbers keep every bit. An unset value becomes null.
/// @param name  of the parameter, for the error
/// @throw InputError naming a parameter whose type YAML does not have (date, binary).
YAML::Node toYaml(const XmlRpc::XmlRpcValue& value, const std::string& name = "");

/// All parameters in the namespace of a node handle. @throw InputError as toYaml
YAML::Node parametersOf(const ros::NodeHandle& node);

}  // namespace sfw
