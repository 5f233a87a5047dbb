// Nothing waits for an inference, however long the drive was.

#include <gtest/gtest.h>
#include <nav_msgs/GetMap.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <cmath>
#include <thread>

#include "mapping_nodelet_world.h"
#include "ros/mapping/shared_mapper.h"
#include "ros/service_call.h"
#include "support/slowdown.h"

namespace sfw {
namespace {

constexpr int kLegs = 45;         // of 20 s and 10 m: a quarter of an hour
constexpr int kLegSamples = 100;  // 5 a second
constexpr double kLegTime = 20.0;
constexpr double kLegWay = 10.0;

/// Up and down a hall, a wall between the two halves.
Position positionAt(int leg, double share) {
  return {kLegWay * (leg % 2 == 0 ? share : 1.0 - share), 0.4 * leg};
}

float rssiAt(const Position& position, const Position& access_point) {
  const bool same_half = (position.x() < 5.0) == (access_point.x() < 5.0);
  return static_cast<float>(-45.0 - 12.0 * std::log10(1.0 + (position - access_point).norm()) -
                            (same_half ? 0.0 : 7.0));
}

TEST(SharedMapper, TakesReadingsWhileAMapIsInferred) {
  std::vector<AccessPoint> access_points(2);
  access_points[0] = {*Bssid::parse("02:00:00:00:00:01"), "", {1.0, 1.0}, {}, {}};
  access_points[1] = {*Bssid::parse("02:00:00:00:00:02"), "", {9.0, 9.0}, {}, {}};
  SharedMapper mapper(Config(), access_points, jumpTolerance({}));
  std::int64_t stamp_ns = 0;
  const auto read = [&](int leg, double share) {
    for (const AccessPoint& access_point : access_points) {
      const Position position = positionAt(leg, share);
      mapper.insert(
          {{{++stamp_ns, position, access_point.bssid, rssiAt(position, access_point.position)}},
           {},
           {}});
    }
  };
  for (int leg = 0; leg < kLegs; ++leg) {
    for (int i = 0; i < kLegSamples; ++i) {
      read(leg, static_cast<double>(i) / kLegSamples);
    }
  }
  std::atomic<bool> inferring{false}, done{false};
  std::thread inference([&] {
    const SharedMapper::Copy copy = mapper.corrected({});
    inferring = true;
    const std::atomic<bool> never{false};
    EXPECT_EQ(copy.mapper.infer(never)->access_points[0].readings,
              static_cast<std::size_t>(kLegs * kLegSamples));
    done = true;
  });
  while (!inferring) {
    std::this_thread::yield();
  }
  int taken = 0;
  for (; !done && taken < 1000; ++taken) {
    read(taken % kLegs, 0.5);
  }
  EXPECT_EQ(taken, 1000) << "the inference was over before";
  mapper.reset();
  EXPECT_FALSE(done);
  inference.join();
  EXPECT_EQ(mapper.corrected({}).mapper.readings().size(), 0U);
}

class LiveMappingTest : public NodeletWorld {
 protected:
  static constexpr int kReadings = 2 * kLegs * kLegSamples;

  void SetUp() override {
    NodeletWorld::SetUp();
    // The clock leaps by whole legs, and a scan may come before its poses: no wait is too long.
    ros::param::set(name_ + "/mapping/ros/transform_timeout", 2.0 * kLegs * kLegTime);
    ros::param::set(name_ + "/mapping/ros/max_waiting", kReadings);  // however slow the machine is
  }

  /// A leg as two poses and one late scan with all readings in between.
  void sendLeg(int leg) {
    const double start_s = kLegTime * leg;
    for (const double share : {0.0, 1.0}) {
      const Position position = positionAt(leg, share);
      sendPose(start_s + share * (kLegTime - 0.1), position.x(), position.y());
    }
    structure_from_wifi::WifiScan scan;
    scan.header.stamp = at(start_s + kLegTime - 0.1);
    for (int i = 0; i < kLegSamples; ++i) {
      const double age_s = 0.199 * i;
      const Position position = positionAt(leg, 1.0 - age_s / (kLegTime - 0.1));
      for (const auto& [bssid, access_point] :
           {std::make_pair(kNear, Position(0.5, 0.5)), std::make_pair(kFar, Position(4.0, 3.0))}) {
        structure_from_wifi::ApReading reading;
        reading.bssid = bssid;
        reading.rssi_dbm = rssiAt(position, access_point);
        reading.age_s = static_cast<float>(age_s);
        scan.readings.push_back(reading);
      }
    }
    ros::Time::setNow(scan.header.stamp);
    scans_.publish(scan);
    ros::WallDuration(0.03).sleep();
  }

  double secondsToUnloadAtWork() {
    load();
    for (int leg = 0; leg < kLegs; ++leg) {
      sendLeg(leg);
    }
    ros::WallDuration(0.3).sleep();
    return secondsToUnload();
  }
};

TEST_F(LiveMappingTest, AnswersAndTakesReadingsWhileItMaps) {
  load();
  for (int leg = 0; leg < kLegs; ++leg) {
    sendLeg(leg);
  }
  EXPECT_EQ(rows(kReadings).size(), std::size_t{kReadings});

  std::atomic<bool> saved{false};
  std::thread saving([&] {
    savedFile("map.pgm");  // waits for an inference of its own
    saved = true;
  });
  int answers = 0;
  while (!saved) {
    nav_msgs::GetMap map;
    EXPECT_TRUE(callService(name_ + "/dynamic_map", map));
    answers += saved ? 0 : 1;
  }
  saving.join();
  EXPECT_GT(answers, 1) << "dynamic_map waited for save_map";
}

TEST_F(LiveMappingTest, AResetOutdatesTheMapThatIsBeingMade) {
  load();
  for (int leg = 0; leg < kLegs; ++leg) {
    sendLeg(leg);
  }
  const auto knows = [&] {
    return map_ && std::count(map_->data.begin(), map_->data.end(), -1) !=
                       static_cast<std::ptrdiff_t>(map_->data.size());
  };
  EXPECT_TRUE(spinUntil(knows, 30.0));
  sendLeg(kLegs);
  ros::WallDuration(0.1).sleep();  // it is at work again
  std_srvs::Trigger reset;
  ASSERT_TRUE(callService(name_ + "/mapping/reset", reset));
  EXPECT_TRUE(reset.response.success);
  EXPECT_TRUE(spinUntil([&] { return !knows(); }, 30.0));
  EXPECT_FALSE(spinUntil(knows, 2.0)) << "a map of before the reset came after it";
}

TEST_F(LiveMappingTest, UnloadsWithinASecondWhileItSolvesForWalls) {
  ros::param::set(name_ + "/mapping/tomography/ensemble_size", 100);
  EXPECT_LT(secondsToUnloadAtWork(), kSlowdown);
}

TEST_F(LiveMappingTest, UnloadsWithinASecondWhileItDescribesCells) {
  ros::param::set(name_ + "/mapping/tomography/ensemble_size", 1);
  ros::param::set(name_ + "/mapping/map/resolution", 0.02);
  EXPECT_LT(secondsToUnloadAtWork(), kSlowdown);
}

}  // namespace
}  // namespace sfw

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "live_mapping_test");
  const ros::NodeHandle node;  // keeps ROS up between the tests
  return RUN_ALL_TESTS();
}
