// A map of 4000 x 4000 cells, and a subscriber that reads none of it: scans are taken at once all
// the same.

#include <gtest/gtest.h>
#include <ros/callback_queue.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "mapping_nodelet_world.h"
#include "stuck_subscriber.h"
#include "support/slowdown.h"

namespace sfw {
namespace {

class SlowSubscriberTest : public NodeletWorld {
 protected:
  void SetUp() override {
    NodeletWorld::SetUp();
    const std::string parameters = name_ + "/mapping";
    ros::param::set(parameters + "/access_points",
                    tableOf({{kNear, 1.5, 1.5}, {kFar, 198.5, 198.5}}));
    ros::param::set(parameters + "/map/growth_step", 1.0);
    ros::param::set(parameters + "/ros/autosave_period", 0.0);
  }

  /// The time from the publication of a scan to the end of the subscriber's callback.
  double latency(const ros::Publisher& publisher, double seconds) {
    auto scan = boost::make_shared<structure_from_wifi::WifiScan>(
        scanOf({{kNear, -50.0F}, {kFar, -60.0F}}));
    scan->header.stamp = at(seconds);
    const ros::SteadyTime start = ros::SteadyTime::now();
    publisher.publish(scan);  // without a copy, so that the owners tell
    while (scan.use_count() > 1 && (ros::SteadyTime::now() - start).toSec() < 10.0) {
      ros::WallDuration(0.00002).sleep();
    }
    return (ros::SteadyTime::now() - start).toSec();
  }
};

double percentile(std::vector<double> values, std::size_t percent) {
  std::sort(values.begin(), values.end());
  return values[values.size() * percent / 100];
}

/// A subscriber that does nothing: its latency is the machine's.
class IdleSubscriber {
 public:
  explicit IdleSubscriber(const std::string& topic) {
    node_.setCallbackQueue(&queue_);
    const boost::function<void(const structure_from_wifi::WifiScanConstPtr&)> ignore =
        [](const structure_from_wifi::WifiScanConstPtr&) {};
    subscriber_ = node_.subscribe<structure_from_wifi::WifiScan>(topic, 10, ignore);
    publisher_ = node_.advertise<structure_from_wifi::WifiScan>(topic, 10);
    spinner_.start();
  }

  const ros::Publisher& publisher() const { return publisher_; }

 private:
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::Subscriber subscriber_;
  ros::Publisher publisher_;
  ros::AsyncSpinner spinner_{1, &queue_};
};

TEST_F(SlowSubscriberTest, HoldsUpNoScan) {
  load();
  consumers_.reset();  // they would be slow, too, in the thread that takes the time
  ASSERT_TRUE(spinUntil([&] { return map_ != nullptr; }, 60.0 * kSlowdown));
  ASSERT_EQ(map_->info.width * map_->info.height, 16'000'000U);
  std::vector<int> sockets;
  for (const char* topic : {"/map", "/map_probability", "/map_costs", "/wall_loss"}) {
    sockets.push_back(StuckSubscriber::connect<nav_msgs::OccupancyGrid>(name_ + topic));
  }
  constexpr int kScans = 1000;
  const nav_msgs::OccupancyGridConstPtr first = map_;
  const IdleSubscriber idle(name_ + "/idle");
  ASSERT_TRUE(spinUntil([&] { return idle.publisher().getNumSubscribers() > 0; }, 5.0));
  std::vector<double> latencies, idle_latencies;
  for (int i = 0; latencies.size() < kScans || (map_ == first && i < 100 * kScans); ++i) {
    const double seconds = 0.05 * i;
    ros::Time::setNow(at(seconds));
    sendPose(seconds, 2.0 + 0.05 * i, 2.0 + std::sin(0.1 * i));
    latencies.push_back(latency(scans_, seconds));
    idle_latencies.push_back(latency(idle.publisher(), seconds));
    ros::spinOnce();
    ros::WallDuration(0.005).sleep();
  }
  EXPECT_NE(map_, first) << "no map was published meanwhile";
  const double p99 = percentile(latencies, 99);
  const double idle_p99 = percentile(idle_latencies, 99);
  std::printf("latency of %zu scans: median %.2f ms, p99 %.2f ms; of the machine: p99 %.2f ms\n",
              latencies.size(), 1e3 * percentile(latencies, 50), 1e3 * p99, 1e3 * idle_p99);
  EXPECT_LT(p99, idle_p99 + 0.020 * kSlowdown);
  for (const int socket : sockets) {
    close(socket);
  }
}

}  // namespace
}  // namespace sfw

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "slow_subscriber_test");
  const ros::NodeHandle node;  // keeps ROS up between the tests
  return RUN_ALL_TESTS();
}
