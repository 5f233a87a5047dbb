#include "ros/conversion/robot_topics.h"

#include <gtest/gtest.h>
#include <ros/names.h>

#include <string>
#include <vector>

namespace sfw {
namespace {

using Names = std::vector<std::string>;

TEST(RobotTopics, ARobotHasTheShortestBeginningOfItsFrame) {
  EXPECT_EQ(robotNames({"robot1/base_link", "robot2/base_link"}), (Names{"robot1", "robot2"}));
  EXPECT_EQ(robotNames({"robot1/arm/wifi", "robot2/wifi"}), (Names{"robot1", "robot2"}));
  EXPECT_EQ(robotNames({"fleet/a/wifi", "fleet/b/wifi"}), (Names{"fleet/a", "fleet/b"}));
  EXPECT_EQ(robotNames({"wifi_a", "wifi_b"}), (Names{"wifi_a", "wifi_b"}));
  EXPECT_EQ(robotNames({"base_link", "robot2/base_link"}), (Names{"base_link", "robot2"}));
  EXPECT_EQ(robotNames({"robot1", "robot10/wifi"}), (Names{"robot1", "robot10"}));
  EXPECT_EQ(robotNames({"one/left", "one/right"}), (Names{"one/left", "one/right"}));
  EXPECT_EQ(robotNames({"a", "a/b"}), (Names{"a", "a/b"}));
}

TEST(RobotTopics, ARobotsNameIsOneOfATopic) {
  const Names names = robotNames({"robot-1/wifi", "2/wifi", "roboter \xc3\xa4/wifi"});
  EXPECT_EQ(names, (Names{"robot_1", "robot_2", "roboter___"}));
  for (const std::string& name : names) {
    std::string error;
    EXPECT_TRUE(ros::names::validate(name + "/contact", error)) << error;
  }
}

TEST(RobotTopics, ATopicIsOfTheRobotInWhoseNamespaceItLies) {
  const Names frames{"robot1/wifi", "robot10/wifi"};
  EXPECT_EQ(robotOfTopic("/robot1/contact", frames), "robot1/wifi");
  EXPECT_EQ(robotOfTopic("robot10/contact", frames), "robot10/wifi");
  EXPECT_EQ(robotOfTopic("/fleet/robot10/bumper/state", frames), "robot10/wifi");
  EXPECT_EQ(robotOfTopic("/contact", frames), "");
  EXPECT_EQ(robotOfTopic("/robot1", frames), "") << "it is no namespace";
  EXPECT_EQ(robotOfTopic("/my_robot1/contact", frames), "");
  EXPECT_EQ(robotOfTopic("/a/b/contact", {"a", "a/b"}), "a/b");
  EXPECT_EQ(robotOfTopic("/any/contact", {"robot1/wifi"}), "robot1/wifi") << "it is alone";
}

}  // namespace
}  // namespace sfw
