// The md5 sums are those of the original octomap_msgs and wireless_msgs packages: with any other,
// their nodes would refuse to talk to ours.
#include <gtest/gtest.h>
#include <octomap_msgs/BoundingBoxQuery.h>
#include <octomap_msgs/GetOctomap.h>
#include <octomap_msgs/Octomap.h>
#include <octomap_msgs/OctomapWithPose.h>
#include <ros/message_traits.h>
#include <ros/service_traits.h>
#include <wireless_msgs/Connection.h>

namespace {

TEST(Interfaces, Octomap) {
  EXPECT_STREQ("octomap_msgs/Octomap", ros::message_traits::datatype<octomap_msgs::Octomap>());
  EXPECT_STREQ("9a45536b45c5e409cd49f04bb2d9999f",
               ros::message_traits::md5sum<octomap_msgs::Octomap>());
  EXPECT_TRUE(ros::message_traits::hasHeader<octomap_msgs::Octomap>());
}

TEST(Interfaces, OctomapWithPose) {
  EXPECT_STREQ("octomap_msgs/OctomapWithPose",
               ros::message_traits::datatype<octomap_msgs::OctomapWithPose>());
  EXPECT_STREQ("20b380aca6a508a657e95526cddaf618",
               ros::message_traits::md5sum<octomap_msgs::OctomapWithPose>());
}

TEST(Interfaces, Connection) {
  EXPECT_STREQ("wireless_msgs/Connection",
               ros::message_traits::datatype<wireless_msgs::Connection>());
  EXPECT_STREQ("f1a0d060cec0bda21949621526aa056e",
               ros::message_traits::md5sum<wireless_msgs::Connection>());
  EXPECT_FALSE(ros::message_traits::hasHeader<wireless_msgs::Connection>());
}

TEST(Interfaces, GetOctomap) {
  EXPECT_STREQ("octomap_msgs/GetOctomap",
               ros::service_traits::datatype<octomap_msgs::GetOctomap>());
  EXPECT_STREQ("be9d2869d24fe40d6bc21ac21f6bb2c5",
               ros::service_traits::md5sum<octomap_msgs::GetOctomap>());
}

TEST(Interfaces, BoundingBoxQuery) {
  EXPECT_STREQ("octomap_msgs/BoundingBoxQuery",
               ros::service_traits::datatype<octomap_msgs::BoundingBoxQuery>());
  EXPECT_STREQ("93aa3d73b866f04880927745f4aab303",
               ros::service_traits::md5sum<octomap_msgs::BoundingBoxQuery>());
}

}  // namespace
