// Sessions of the mapping nodelet: what it saves, keeps and takes up again.

#include <gtest/gtest.h>
#include <std_srvs/Trigger.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "mapping_nodelet_world.h"

namespace sfw {
namespace {

namespace fs = std::filesystem;

class NodeletSessionTest : public NodeletWorld {
 protected:
  /// Readings along a line of 3 m; returns how many.
  std::size_t drive(double start_s = 0.0, double y = 1.0) {
    constexpr int kScans = 60;
    for (int i = 0; i < kScans; ++i) {
      sendPose(start_s + 0.05 * i, 0.05 * i, y);
      sendScan(start_s + 0.05 * i, {{kNear, -50.0F - static_cast<float>(i % 7)}, {kFar, -60.0F}});
    }
    return std::size_t{2} * kScans;
  }

  void reset() {
    std_srvs::Trigger call;
    ASSERT_TRUE(ros::service::call(name_ + "/mapping/reset", call));
    EXPECT_TRUE(call.response.success);
  }

  static std::string contentOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
};

TEST_F(NodeletSessionTest, SavingNothingFailsWithTheReason) {
  load();
  const auto response = save("nothing");
  EXPECT_FALSE(response.success);
  EXPECT_NE(response.message.find("no message has come on " + name_ + "/wifi_scan"),
            std::string::npos)
      << response.message;
  EXPECT_FALSE(fs::exists(folder_ / "nothing"));
}

TEST_F(NodeletSessionTest, SavingNeverReplacesAnotherSession) {
  load();
  const std::size_t readings = drive();
  ASSERT_EQ(rows(readings).size(), readings);
  const std::string first = contentOf(folder_ / "saved" / "readings.csv");
  EXPECT_EQ(save("saved").message, (folder_ / "saved").string()) << "the same session goes on";
  reset();
  sendPose(100.0, 1.0, 1.0);
  sendScan(100.0, {{kNear, -50.0F}});
  ASSERT_EQ(rows(1).size(), 1U);
  EXPECT_EQ(save("saved").message, (folder_ / "saved_2").string());
  EXPECT_EQ(contentOf(folder_ / "saved" / "readings.csv"), first);
}

}  // namespace
}  // namespace sfw

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "nodelet_session_test");
  const ros::NodeHandle node;  // keeps ROS up between the tests
  return RUN_ALL_TESTS();
}
