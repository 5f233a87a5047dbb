// Scans, resets and every service at once: for a minute under the thread sanitizer.

#include <gtest/gtest.h>
#include <nav_msgs/GetMap.h>
#include <octomap_msgs/GetOctomap.h>
#include <std_srvs/Trigger.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <set>
#include <string_view>
#include <thread>

#include "mapping_nodelet_world.h"
#include "ros/service_call.h"
#include "structure_from_wifi/access_points_io.h"
#include "structure_from_wifi/map_files.h"
#include "structure_from_wifi/mapper.h"
#include "structure_from_wifi/readings_io.h"
#include "support/slowdown.h"

namespace sfw {
namespace {

constexpr double kSeconds = 6.0 * kSlowdown;

/// A served or published grid in short: its stamp and a hash of its cells.
using Version = std::pair<std::uint64_t, std::size_t>;

Version versionOf(const nav_msgs::OccupancyGrid& grid) {
  const std::string_view cells(reinterpret_cast<const char*>(grid.data.data()), grid.data.size());
  return {grid.header.stamp.toNSec(), std::hash<std::string_view>()(cells)};
}

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The map of a saved recording, made anew.
std::string remadeMap(const std::filesystem::path& saved) {
  Mapper mapper(Config(), readAccessPoints(saved / "access_points.yaml").access_points);
  for (const Reading& reading : readReadings(saved / "readings.csv").readings) {
    mapper.insert(reading);
  }
  return trinaryPgm(mapper.infer()->belief);
}

class ConcurrentCallsTest : public NodeletWorld {
 protected:
  void SetUp() override {
    NodeletWorld::SetUp();
    versions_subscriber_ = ros::NodeHandle().subscribe<nav_msgs::OccupancyGrid>(
        name_ + "/map", 1000,
        [this](const nav_msgs::OccupancyGridConstPtr& map) { published_.insert(versionOf(*map)); });
  }

  /// Repeats a piece of work in a thread of its own until the end.
  void repeat(double pause_s, const std::function<void()>& work) {
    threads_.emplace_back([this, pause_s, work] {
      while (!done_) {
        work();
        ros::WallDuration(pause_s).sleep();
      }
    });
  }

  void drive(int step) {
    const double seconds = 0.05 * step;
    ros::Time::setNow(at(seconds));
    sendPose(seconds, 2.0 + 1.8 * std::sin(0.1 * step), 1.5 + 1.3 * std::sin(0.037 * step));
    sendScan(seconds, {{kNear, -45.0F - static_cast<float>(step % 20)},
                       {kFar, -50.0F - static_cast<float>(step % 13)}});
  }

  template <class Service>
  Service call(const std::string& service) {
    Service message;
    EXPECT_TRUE(callService(name_ + service, message)) << service;
    return message;
  }

  std::atomic<bool> done_{false};
  std::vector<std::thread> threads_;
  std::set<Version> published_;  // in the main thread
  ros::Subscriber versions_subscriber_;
};

TEST_F(ConcurrentCallsTest, EachMapIsOneVersion) {
  load();
  ASSERT_TRUE(spinUntil([&] { return !published_.empty(); }, 30.0));
  std::set<Version> served;
  std::atomic<int> resets{0}, octomaps{0}, saves{0};
  int step = 0;
  repeat(0.002, [&] { drive(step++); });
  repeat(0.005,
         [&] { served.insert(versionOf(call<nav_msgs::GetMap>("/dynamic_map").response.map)); });
  repeat(0.2, [&] {
    EXPECT_TRUE(call<std_srvs::Trigger>("/mapping/reset").response.success);
    ++resets;
  });
  repeat(0.01, [&] {
    call<octomap_msgs::GetOctomap>("/octomap_binary");
    ++octomaps;
  });
  repeat(0.01, [&] {
    const structure_from_wifi::SaveMap::Response saved = save("saved");
    if (saved.success) {
      EXPECT_TRUE(contentOf(saved.message + "/map.pgm") == remadeMap(saved.message))
          << "the saved map is not that of the saved readings";
      ++saves;
    }
  });
  spinUntil([] { return false; }, kSeconds);
  done_ = true;
  for (std::thread& thread : threads_) {
    thread.join();
  }
  // The last map may be served before its message arrives.
  spinUntil(
      [&] {
        return std::includes(published_.begin(), published_.end(), served.begin(), served.end());
      },
      5.0);
  EXPECT_GT(resets, 3);
  EXPECT_GT(octomaps, 3);
  EXPECT_GT(saves, 3);
  EXPECT_GT(served.size(), 3U);
  for (const Version& version : served) {
    EXPECT_EQ(published_.count(version), 1U)
        << "a map was served that was never published, of the stamp " << version.first;
  }
}

}  // namespace
}  // namespace sfw

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "concurrent_calls_test");
  const ros::NodeHandle node;  // keeps ROS up between the tests
  return RUN_ALL_TESTS();
}
