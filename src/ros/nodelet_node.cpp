// A node that loads one nodelet. It is compiled once for each nodelet. SFW_NODE is the node's
// default name, and SFW_NODELET is the nodelet's name.

#include <nodelet/loader.h>
#include <ros/ros.h>

#include <algorithm>

namespace {

/// Whether the nodelet advertises anything besides the log and its diagnostics. onInit must not
/// throw, so a nodelet with unusable parameters loads all the same, but it advertises nothing else.
bool somethingIsAdvertised() {
  ros::V_string topics;
  ros::this_node::getAdvertisedTopics(topics);
  return std::any_of(topics.begin(), topics.end(), [](const std::string& topic) {
    return topic != "/rosout" && topic != "/diagnostics";
  });
}

}  // namespace

int main(int argc, char** argv) {
  try {
    ros::init(argc, argv, SFW_NODE);
    const ros::NodeHandle node;  // keeps ROS running until the nodelet is destroyed
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
