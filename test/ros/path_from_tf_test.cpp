// The path between readings, the frame of the odometry, and transforms with two publishers.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "ros/conversion/message_conversion.h"
#include "ros/mapping/floors.h"
#include "ros/mapping/observation_queue.h"
#include "ros/mapping/odometry_frame.h"
#include "ros/mapping/path_sampler.h"
#include "ros/mapping/transform_watch.h"

namespace sfw {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

class PathFromTf : public testing::Test {
 protected:
  void set(double seconds, const std::string& parent, const std::string& child, double x,
           bool is_static = false) {
    const geometry_msgs::TransformStamped transform =
        toPlanarTransform(ros::Time(seconds), parent, child, {x, 0.0}, 0.0);
    transforms_.setTransform(transform, "test", is_static);
    watch_.observe(transform, "/" + parent);
  }

  /// Drives along x from one time to another, with tf at 5 Hz.
  void drive(double from, double to, double speed, const std::string& odom = "odom") {
    for (double t = from; t < to + 0.01; t += 0.2) {
      set(t, "map", odom, 1.0);
      set(t, odom, "base_link", speed * (t - from));
    }
  }

  RosSettings settings_;
  tf2::BufferCore transforms_{ros::Duration(1e6)};
  TransformWatch watch_;
};

// ---- Samples of the path ----

TEST_F(PathFromTf, IsSampledEachTenthOfASecondFromReadingToReading) {
  drive(100.0, 110.0, 0.3);
  PathSampler sampler(settings_);
  EXPECT_TRUE(sampler.extendTo(102 * kSecond + 1, transforms_).empty());
  const auto way = sampler.extendTo(106 * kSecond, transforms_);
  ASSERT_EQ(way.size(), 40U);
  EXPECT_EQ(way.front().pose.stamp_ns, 102 * kSecond + kSecond / 10);
  EXPECT_NEAR(way.front().pose.antenna_in_map.x(), 1.0 + 0.3 * 2.1, 1e-6);
  ASSERT_TRUE(way.front().correction);
  EXPECT_NEAR(way.front().correction->odom_in_map.x(), 1.0, 1e-9);
  EXPECT_TRUE(sampler.extendTo(104 * kSecond, transforms_).empty()) << "is sampled already";
}

TEST_F(PathFromTf, HasTheSameSamplesInAnyOrderOfReadings) {
  drive(100.0, 110.0, 0.3);
  const auto sampled = [&](const std::vector<double>& seconds) {
    PathSampler sampler(settings_);
    std::vector<std::int64_t> stamps;
    for (const double s : seconds) {
      for (const LocatedPose& sample :
           sampler.extendTo(static_cast<std::int64_t>(s * 1e9), transforms_)) {
        stamps.push_back(sample.pose.stamp_ns);
      }
    }
    std::sort(stamps.begin(), stamps.end());
    return stamps;
  };
  const auto in_order = sampled({101.05, 103.0, 105.55, 108.3});
  EXPECT_EQ(in_order.size(), 73U);
  EXPECT_EQ(sampled({103.0, 101.05, 108.3, 105.55}), in_order);
  EXPECT_EQ(sampled({108.3, 105.55, 103.0, 101.05}), in_order);
}

TEST_F(PathFromTf, HasNoSampleOfARobotThatStandsStill) {
  drive(100.0, 110.0, 0.0);
  PathSampler sampler(settings_);
  sampler.extendTo(101 * kSecond, transforms_);
  EXPECT_LE(sampler.extendTo(109 * kSecond, transforms_).size(), 1U);
}

TEST_F(PathFromTf, IsNotSampledForLongerThanTfKeepsTransforms) {
  drive(100.0, 200.0, 0.3);
  PathSampler sampler(settings_);
  sampler.extendTo(101 * kSecond, transforms_);
  const auto way = sampler.extendTo(199 * kSecond, transforms_);
  const double most_s = settings_.tf_cache_s - settings_.transform_timeout_s;
  EXPECT_NEAR(static_cast<double>(way.size()), 10.0 * most_s, 1.5);
  EXPECT_TRUE(sampler.extendTo(4'000'000 * kSecond, transforms_).empty()) << "no transform there";
}

TEST_F(PathFromTf, ComesWithAReadingThatTheQueueLocates) {
  drive(100.0, 110.0, 0.3);
  ObservationQueue queue(settings_);
  const Bssid bssid = *Bssid::parse("02:00:00:00:00:01");
  std::size_t samples = 0;
  for (const double s : {101.0, 105.0}) {
    queue.push({{ros::Time(s), UnlocatedReading{bssid, -50.0}}});
    queue.locate(transforms_, ros::Time(110.0),
                 [&](const LocatedObservation& located) { samples += located.way.size(); });
  }
  EXPECT_EQ(samples, 40U);
}

// ---- The frame of the odometry ----

TEST_F(PathFromTf, FindsTheOdometryByAnyName) {
  for (const std::string odom : {"odom", "tb3_0/odom", "wheels"}) {
    transforms_.clear();
    drive(100.0, 102.0, 0.3, odom);
    EXPECT_EQ(odometryFrame(settings_, transforms_), odom);
  }
  settings_.odom_frame = "named";
  EXPECT_EQ(odometryFrame(settings_, transforms_), "named");
  settings_.odom_frame = settings_.map_frame;
  EXPECT_EQ(odometryFrame(settings_, transforms_), "") << "switched off";
}

TEST_F(PathFromTf, FindsTheOdometryBetweenStaticFrames) {
  set(0.0, "map", "building", 0.0, true);
  set(100.0, "building", "odom_combined", 0.5);
  set(100.0, "odom_combined", "base_link", 1.5);
  set(0.0, "base_link", "antenna", 0.2, true);
  settings_.antenna_frame = "antenna";
  EXPECT_EQ(framesBetween("map", "antenna", transforms_),
            (std::vector<std::string>{"map", "building", "odom_combined", "base_link", "antenna"}));
  EXPECT_EQ(odometryFrame(settings_, transforms_), "odom_combined");
}

TEST_F(PathFromTf, FindsTheOdometryAboveTheMap) {
  set(100.0, "odom", "map", -0.5);
  set(100.0, "odom", "base_link", 1.5);
  EXPECT_EQ(odometryFrame(settings_, transforms_), "odom");
}

TEST_F(PathFromTf, HasNoOdometryIfTheMapMovesTheRobotItself) {
  set(100.0, "map", "base_link", 0.5);
  set(0.0, "base_link", "antenna", 0.2, true);
  settings_.antenna_frame = "antenna";
  EXPECT_EQ(odometryFrame(settings_, transforms_), "");
  settings_.antenna_frame = "elsewhere";
  EXPECT_EQ(odometryFrame(settings_, transforms_), "");
}

// ---- Transforms with two publishers ----

TEST_F(PathFromTf, TellsOfATransformThatGoesToAndFro) {
  drive(100.0, 110.0, 0.3);
  EXPECT_EQ(watch_.finding("base_link").published_twice, "");
  for (int i = 0; i < 20; ++i) {
    set(110.0 + i, "map", "odom", i % 2 == 0 ? 0.0 : 1.0);
    watch_.observe(
        toPlanarTransform(ros::Time(110.0 + i), "base_link", "wheel", {}, i % 2 == 0 ? 0.0 : 3.0),
        "/wheels");
  }
  const FrameFinding finding = watch_.finding("base_link");
  EXPECT_EQ(finding.published_twice, "map to odom");
  EXPECT_NEAR(static_cast<double>(finding.flips), 19.0, 1.0);
  watch_.clear();
  EXPECT_EQ(watch_.finding("base_link").published_twice, "");
}

TEST_F(PathFromTf, NamesBothPublishersAndKnowsTwoParents) {
  for (int i = 0; i < 30; ++i) {
    const std::string parent = i % 2 == 0 ? "odom" : "odom_combined";
    watch_.observe(toPlanarTransform(ros::Time(1.0 + i), parent, "base_link", {0.02 * i, 0.0}, 0.0),
                   i % 2 == 0 ? "/wheels" : "/ekf");
  }
  const std::string text = watch_.finding("base_link").published_twice;
  EXPECT_NE(text.find("to base_link (by /ekf, /wheels)"), std::string::npos) << text;
}

TEST_F(PathFromTf, SaysNothingOfLoopClosures) {
  for (int i = 0; i < 2000; ++i) {
    watch_.observe(toPlanarTransform(ros::Time(1.0 + 0.1 * i), "map", "odom",
                                     {0.3 * (i / 100), 0.1 * (i / 200 % 2)}, 0.0),
                   "/slam");
  }
  EXPECT_EQ(watch_.finding("odom").published_twice, "");
}

// ---- Floors ----

TEST(Floors, AreFoundByTheHeightsOfTheAntenna) {
  Floors floors;
  for (int i = 0; i < 1000; ++i) {
    floors.observe(0.45 + 0.02 * (i % 5));
  }
  EXPECT_EQ(floors.heights().size(), 1U);
  for (int i = 0; i < 20; ++i) {
    floors.observe(0.15 * i);  // in the lift
  }
  for (int i = 0; i < 300; ++i) {
    floors.observe(3.2 + 0.01 * (i % 5));
  }
  const std::vector<double> heights = floors.heights();
  ASSERT_EQ(heights.size(), 2U);
  EXPECT_NEAR(heights[0], 0.5, 0.1);
  EXPECT_NEAR(heights[1], 3.2, 0.1);
  floors.clear();
  EXPECT_TRUE(floors.heights().empty());
}

TEST(Floors, AreNotMadeByARamp) {
  Floors floors;
  for (int i = 0; i < 1000; ++i) {
    floors.observe(0.004 * i);
  }
  EXPECT_EQ(floors.heights().size(), 1U);
}

}  // namespace
}  // namespace sfw
