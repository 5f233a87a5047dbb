#include "ros/mapping/observation_queue.h"

#include <gtest/gtest.h>
#include <tf2/buffer_core.h>

#include <new>
#include <stdexcept>
#include <vector>

namespace sfw {
namespace {

geometry_msgs::TransformStamped mapFromAntenna(double seconds, double x) {
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = ros::Time(seconds);
  transform.header.frame_id = "map";
  transform.child_frame_id = "antenna";
  transform.transform.translation.x = x;
  transform.transform.rotation.w = 1.0;
  return transform;
}

RosSettings rosConfig() {
  RosSettings config;
  config.antenna_frame = "antenna";
  config.transform_timeout_s = 5.0;
  config.max_waiting = 2;
  return config;
}

Observation observationAt(double seconds, double rssi_dbm = -50.0) {
  return {ros::Time(seconds), UnlocatedReading{*Bssid::parse("02:00:00:00:00:01"), rssi_dbm}};
}

TEST(ObservationQueue, LocatesWhatTfKnowsAndKeepsTheRest) {
  tf2::BufferCore transforms;
  transforms.setTransform(mapFromAntenna(10.0, 1.0), "test");
  transforms.setTransform(mapFromAntenna(11.0, 3.0), "test");
  ObservationQueue queue(rosConfig());
  queue.push({observationAt(12.0)});
  queue.push({observationAt(10.5)});
  std::vector<double> located_x;
  const auto sink = [&](const LocatedObservation& located) {
    located_x.push_back(located.readings.at(0).antenna_in_map.x());
  };
  EXPECT_EQ(queue.locate(transforms, ros::Time(12.0), sink).located, 1U);
  transforms.setTransform(mapFromAntenna(12.0, 5.0), "test");
  EXPECT_EQ(queue.locate(transforms, ros::Time(12.1), sink).located, 1U);
  EXPECT_EQ(located_x, (std::vector<double>{2.0, 5.0}));
}

TEST(ObservationQueue, DropsObservationsThatWaitTooLongOrAreTooMany) {
  const tf2::BufferCore transforms;
  ObservationQueue queue(rosConfig());
  for (const double seconds : {10.0, 11.0, 12.0}) {
    queue.push({observationAt(seconds)});
  }
  const auto unexpected = [](const LocatedObservation&) { FAIL() << "tf knows no transform"; };
  const ObservationQueue::Outcome first = queue.locate(transforms, ros::Time(14.0), unexpected);
  EXPECT_EQ(first.overflowed, 1U);
  EXPECT_EQ(first.expired, 0U);
  const ObservationQueue::Outcome later = queue.locate(transforms, ros::Time(17.5), unexpected);
  EXPECT_EQ(later.overflowed, 0U);
  EXPECT_EQ(later.expired, 2U);
  EXPECT_NE(later.tf_error, "");
}

TEST(ObservationQueue, UnusableObservationsTakeNoPlaceOfUsableOnes) {
  const tf2::BufferCore no_transforms;
  RosSettings config = rosConfig();
  config.max_waiting = 20;
  ObservationQueue queue(config);
  const Observation percent = observationAt(10.0, 70.0);
  for (int i = 0; i < 20; ++i) {
    queue.push({observationAt(10.0 + 0.01 * i)});
  }
  for (int i = 0; i < 1000; ++i) {
    queue.push({percent});
  }
  const auto unexpected = [](const LocatedObservation&) { FAIL() << "tf knows no transform"; };
  const ObservationQueue::Outcome flooded =
      queue.locate(no_transforms, ros::Time(11.0), unexpected);
  EXPECT_EQ(flooded.overflowed, 0U);
  EXPECT_EQ(flooded.unusable, 998U);
  EXPECT_EQ(queue.size(), 22U);
  queue.push({observationAt(11.0)});  // after a call of locate() the counts hold, too
  queue.push({percent});
  const ObservationQueue::Outcome later = queue.locate(no_transforms, ros::Time(11.0), unexpected);
  EXPECT_EQ(later.overflowed, 1U);
  EXPECT_EQ(later.unusable, 1U);
}

TEST(ObservationQueue, AnOldUnusableObservationGoesWithTheOldestUsableOne) {
  const tf2::BufferCore no_transforms;
  ObservationQueue queue(rosConfig());  // two may wait
  queue.push({observationAt(10.0, 70.0)});
  for (const double seconds : {10.0, 11.0, 12.0}) {
    queue.push({observationAt(seconds)});
  }
  const auto unexpected = [](const LocatedObservation&) { FAIL() << "tf knows no transform"; };
  const ObservationQueue::Outcome outcome =
      queue.locate(no_transforms, ros::Time(12.0), unexpected);
  EXPECT_EQ(outcome.overflowed, 1U);
  EXPECT_EQ(outcome.unusable, 1U);
  EXPECT_EQ(queue.size(), 2U);
}

TEST(ObservationQueue, DropsNoReadingOfTheNewestMessage) {
  const tf2::BufferCore no_transforms;
  ObservationQueue queue(rosConfig());  // two may wait
  queue.push({observationAt(10.0)});
  queue.push({observationAt(11.0), observationAt(11.0), observationAt(11.0)});
  const auto unexpected = [](const LocatedObservation&) { FAIL() << "tf knows no transform"; };
  EXPECT_EQ(queue.locate(no_transforms, ros::Time(12.0), unexpected).overflowed, 1U);
  EXPECT_EQ(queue.size(), 3U);
  queue.push({observationAt(12.0)});
  EXPECT_EQ(queue.locate(no_transforms, ros::Time(12.0), unexpected).overflowed, 1U);
  EXPECT_EQ(queue.size(), 3U) << "the queue does not grow";
}

class FailingSink : public testing::Test {
 protected:
  void SetUp() override {
    transforms_.setTransform(mapFromAntenna(0.0, 1.0), "test", true);
    for (int i = 1; i <= 5; ++i) {
      queue_.push({observationAt(i)});
    }
  }

  /// Passes on all observations to a sink that throws at the third call.
  template <class Exception>
  void locateWith(const Exception& exception) {
    queue_.locate(transforms_, ros::Time(5.0), [&](const LocatedObservation& located) {
      if (++calls_ == 3) {
        throw exception;
      }
      stamps_.push_back(static_cast<double>(located.readings.at(0).stamp_ns) / 1e9);
    });
  }

  tf2::BufferCore transforms_;
  RosSettings settings_ = [] {
    RosSettings settings = rosConfig();
    settings.max_waiting = 10;
    return settings;
  }();
  ObservationQueue queue_{settings_};
  int calls_ = 0;
  std::vector<double> stamps_;
};

TEST_F(FailingSink, LosesOneObservation) {
  const std::runtime_error error("it cannot be used");
  EXPECT_THROW(locateWith(error), std::runtime_error);
  EXPECT_EQ(queue_.size(), 2U);
  locateWith(error);
  EXPECT_EQ(stamps_, (std::vector<double>{1.0, 2.0, 4.0, 5.0}));
}

TEST_F(FailingSink, LosesNoObservationWithoutMemory) {
  EXPECT_THROW(locateWith(std::bad_alloc()), std::bad_alloc);
  EXPECT_EQ(queue_.size(), 3U);
  queue_.push({observationAt(5.0)});
  locateWith(std::bad_alloc());
  EXPECT_EQ(stamps_, (std::vector<double>{1.0, 2.0, 3.0, 4.0, 5.0, 5.0}));
}

TEST_F(FailingSink, LosesNoCount) {
  for (int i = 0; i < 7; ++i) {
    queue_.push({observationAt(5.0)});
  }
  EXPECT_THROW(locateWith(std::bad_alloc()), std::bad_alloc);
  EXPECT_EQ(queue_.locate(transforms_, ros::Time(5.0), [](const LocatedObservation&) {}).overflowed,
            2U);
}

}  // namespace
}  // namespace sfw
