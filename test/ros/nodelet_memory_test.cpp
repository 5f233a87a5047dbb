// A mapping nodelet whose memory runs out.

#include <gtest/gtest.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/point_cloud2_iterator.h>
#include <std_srvs/Trigger.h>

#include <algorithm>
#include <boost/make_shared.hpp>

#include "failing_allocations.h"
#include "memory_limit.h"
#include "nodelet_diagnostics_world.h"
#include "shape_of.h"

namespace sfw {
namespace {

using Rows = std::vector<std::string>;

class NodeletMemoryTest : public NodeletDiagnosticsWorld {
 protected:
  using Threads = FailingAllocations::Threads;
  static constexpr int kError = rosgraph_msgs::Log::ERROR;
  static constexpr std::size_t kLarge = 1U << 19U;  // less than the grid of a large map

  void SetUp() override {
    NodeletDiagnosticsWorld::SetUp();
    if (!MemoryLimit::isPossible()) {
      GTEST_SKIP() << "a sanitizer has allocations of its own";
    }
  }

  void makeTheMapLarge(double edge_m = 50.0) {
    ros::param::set(name_ + "/mapping/access_points",
                    tableOf({{kNear, 0.5, 0.5}, {kFar, edge_m, edge_m}}));
  }
};

TEST_F(NodeletMemoryTest, AMessageWithoutMemoryIsCountedAndLeftOut) {
  ros::Publisher clouds =
      ros::NodeHandle().advertise<sensor_msgs::PointCloud2>(name_ + "/contact_points", 10);
  load();
  ASSERT_TRUE(spinUntil([&] { return clouds.getNumSubscribers() > 0; }, 30.0));
  sensor_msgs::PointCloud2 cloud;
  cloud.header.frame_id = "base_link";
  cloud.header.stamp = at(0.0);
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2FieldsByString(1, "xyz");
  modifier.resize(8'000'000);
  const auto message = shapeOf(cloud);
  sendPose(0.0, 1.0, 2.0);
  {
    const MemoryLimit limit(32U << 20U);
    clouds.publish(message);  // not copied within a process
    EXPECT_TRUE(logs(rosgraph_msgs::Log::ERROR, "could not be processed: out of memory"));
  }
  EXPECT_TRUE(
      hasValue("inputs",
               name_ + "/contact_points: rejected: it could not be processed: out of memory; raise "
                       "map/resolution or map a smaller area",
               "1"));
  sendScan(0.0, {{kFar, -60.0F}});
  EXPECT_EQ(rows(1), Rows{row(0.0, 1.0, 2.0, kFar, -60.0)});
  EXPECT_EQ(savedFile("contacts.csv"), "stamp,x,y\n");
}

TEST_F(NodeletMemoryTest, ATransformWithoutMemoryIsLeftOutAndTold) {
  load();
  const auto message = boost::make_shared<tf2_msgs::TFMessage>();
  message->transforms = {transform(0.0, "map", std::string(2 * kLarge, 'x'), 0.0, 0.0)};
  {
    const FailingAllocations shortage(kLarge, Threads::kOthers);
    transforms_.publish(message);  // not copied within a process
    EXPECT_TRUE(logs(kError, "A message of tf is left out: out of memory"));
  }
  sendPose(0.0, 1.0, 2.0);
  sendScan(0.0, {{kFar, -60.0F}});
  EXPECT_EQ(rows(1), Rows{row(0.0, 1.0, 2.0, kFar, -60.0)});
}

TEST_F(NodeletMemoryTest, AMapWithoutMemoryIsTriedAgain) {
  makeTheMapLarge(120.0);
  load();
  ASSERT_TRUE(spinUntil([&] { return map_ != nullptr; }, 30.0));
  {
    const MemoryLimit limit(16U << 20U);
    drive(0.0);
    EXPECT_TRUE(logs(rosgraph_msgs::Log::ERROR, "The map update failed and will be tried again"));
    EXPECT_TRUE(hears("map", diagnostic_msgs::DiagnosticStatus::ERROR, "The map update failed"));
    EXPECT_EQ(std::count(map_->data.begin(), map_->data.end(), 0), 0);
  }
  EXPECT_TRUE(mapAppears());
  EXPECT_EQ(rows(kScans).size(), static_cast<std::size_t>(kScans));
}

TEST_F(NodeletMemoryTest, AShortageThatAlsoTakesTheTextsOfErrorsIsSurvived) {
  makeTheMapLarge();
  load();
  ASSERT_TRUE(spinUntil([&] { return map_ != nullptr; }, 30.0));
  {
    const FailingAllocations shortage(kLarge, Threads::kOthers, 5);
    drive(0.0);
    EXPECT_TRUE(
        spinUntil([&] { return shortage.failures() > 5 * FailingAllocations::kFollowing; }, 30.0));
    EXPECT_TRUE(logs(kError, "The map update failed and will be tried again: out of memory"));
  }
  EXPECT_TRUE(mapAppears());
  EXPECT_EQ(rows(kScans).size(), static_cast<std::size_t>(kScans));
}

TEST_F(NodeletMemoryTest, AStartWithoutMemoryIsToldAndBlamesNoParameter) {
  makeTheMapLarge();
  {
    const FailingAllocations shortage(kLarge, Threads::kAll);
    ASSERT_TRUE(loader_.load(name_ + "/mapping", "structure_from_wifi/MappingNodelet", {}, {}));
    EXPECT_TRUE(logs(kError, "Mapping cannot start: out of memory; raise map/resolution"));
  }
  EXPECT_TRUE(hears("map", diagnostic_msgs::DiagnosticStatus::ERROR,
                    "Mapping cannot start: out of memory"));
  EXPECT_TRUE(hears("inputs", diagnostic_msgs::DiagnosticStatus::ERROR,
                    "Nothing is subscribed: mapping cannot start."));
  EXPECT_FALSE(advertises(name_ + "/map"));
  EXPECT_TRUE(loader_.unload(name_ + "/mapping"));
}

TEST_F(NodeletMemoryTest, AResetWithoutMemoryEmptiesTheMapLater) {
  makeTheMapLarge();
  load();
  drive(0.0);
  ASSERT_EQ(rows(kScans).size(), static_cast<std::size_t>(kScans));
  ASSERT_TRUE(mapAppears());
  std_srvs::Trigger reset;
  {
    const FailingAllocations shortage(kLarge, Threads::kOthers);
    ASSERT_TRUE(callService(name_ + "/mapping/reset", reset));
  }
  EXPECT_FALSE(reset.response.success);
  EXPECT_NE(reset.response.message.find("has to wait: out of memory"), std::string::npos)
      << reset.response.message;
  EXPECT_TRUE(spinUntil(
      [&] {
        return std::count(map_->data.begin(), map_->data.end(), -1) ==
               static_cast<std::ptrdiff_t>(map_->data.size());
      },
      30.0));
}

TEST_F(NodeletMemoryTest, ASaveWithoutMemoryIsToldAndSucceedsLater) {
  makeTheMapLarge();
  load();
  ASSERT_TRUE(spinUntil([&] { return map_ != nullptr; }, 30.0));
  drive(0.0);
  ASSERT_EQ(rows(kScans).size(), static_cast<std::size_t>(kScans));
  {
    const FailingAllocations shortage(kLarge, Threads::kOthers);
    const structure_from_wifi::SaveMap::Response response = save("saved");
    EXPECT_FALSE(response.success);
    EXPECT_NE(response.message.find("out of memory"), std::string::npos) << response.message;
  }
  EXPECT_TRUE(save("saved").success);
}

}  // namespace
}  // namespace sfw

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "nodelet_memory_test");
  const ros::NodeHandle node;  // keeps ROS up between the tests
  return RUN_ALL_TESTS();
}
