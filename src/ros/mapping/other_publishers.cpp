#include "ros/mapping/other_publishers.h"

#include <ros/master.h>
#include <ros/this_node.h>

#include <algorithm>

namespace sfw {
namespace {

bool isAdvertisedByThisProcess(const std::string& topic) {
  ros::V_string topics;
  ros::this_node::getAdvertisedTopics(topics);
  return std::find(topics.begin(), topics.end(), topic) != topics.end();
}

}  // namespace

std::vector<std::string> otherPublishers(const std::string& topic, Advertised advertised) {
  const std::string own = ros::this_node::getName();
  std::vector<std::string> others;
  XmlRpc::XmlRpcValue request, response, state;
  request[0] = own;
  constexpr bool kWaitForMaster = false;
  if (!ros::master::execute("getSystemState", request, response, state, kWaitForMaster)) {
    return others;
  }
  // The master may list a dead node of the same name, which this one replaces.
  const bool own_counts = advertised == Advertised::kNo && isAdvertisedByThisProcess(topic);
  XmlRpc::XmlRpcValue& publishers = state[0];
  for (int i = 0; i < publishers.size(); ++i) {
    if (static_cast<std::string&>(publishers[i][0]) != topic) {
      continue;
    }
    XmlRpc::XmlRpcValue& nodes = publishers[i][1];
    for (int j = 0; j < nodes.size(); ++j) {
      const auto& node = static_cast<std::string&>(nodes[j]);
      if (node != own || own_counts) {
        others.push_back(node);
      }
    }
  }
  return others;
}

}  // namespace sfw
