// A node that loads one nodelet and lives as long as it does. Compiled once for each, with
// SFW_NODE, the node's default name, and SFW_NODELET, the nodelet's, defined.

#include <nodelet/loader.h>
#include <ros/ros.h>

#include <algorithm>

namespace {

/// True if something besides the log comes out of this node. onInit must not throw, so a nodelet
/// that cannot use its parameters loads all the same; what it does not do is advertise.
bool somethingIsAdvertised() {
  ros::V_string topics;
  ros::this_node::getAdvertisedTopics(topics);
  return std::any_of(topics.begin(), topics.end(),
                     [](const std::string& topic) { return topic != "/rosout"; });
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, SFW_NODE);
  const ros::NodeHandle node;  // keeps ROS up until the nodelet is gone
  try {
    nodelet::Loader loader(false);
    const bool loaded = loader.load(ros::this_node::getName(), SFW_NODELET,
                                    ros::names::getRemappings(), {argv + 1, argv + argc});
    if (!loaded || !somethingIsAdvertised()) {
      return EXIT_FAILURE;
    }
    ros::spin();
  } catch (const std::exception& error) {
    ROS_FATAL_STREAM(error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
