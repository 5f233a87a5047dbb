// Drives the simulator node of cmd_vel_simulator.test into walls and away from them.

#include <geometry_msgs/Twist.h>
#include <gtest/gtest.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Bool.h>
#include <structure_from_wifi/WifiScan.h>
#include <tf2_msgs/TFMessage.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace sfw {
namespace {

constexpr double kRadius = 0.15;  // the default

/// All that the simulator says, and the means to drive it.
class Cockpit : public testing::Test {
 protected:
  void SetUp() override {
    commands_ = node_.advertise<geometry_msgs::Twist>("cmd_vel", 10);
    subscribers_ = {node_.subscribe("/tf", 1000, &Cockpit::receiveTransforms, this),
                    node_.subscribe("contact", 100, &Cockpit::receiveContact, this),
                    node_.subscribe("finished", 10, &Cockpit::receiveFinished, this),
                    node_.subscribe("odom", 100, &Cockpit::receiveOdometry, this),
                    node_.subscribe("scan", 100, &Cockpit::receiveLaserScan, this),
                    node_.subscribe("truth", 1, &Cockpit::receiveTruth, this),
                    node_.subscribe("wifi_scan", 100, &Cockpit::receiveScan, this)};
    ASSERT_TRUE(spinUntil([this] {
      return truth_ && !contacts_.empty() && !poses_.empty() && commands_.getNumSubscribers() > 0;
    }));
    ASSERT_TRUE(spinUntil([this] { return standsStill(); }));
  }

  /// Handles messages until something becomes true or real time runs out.
  static bool spinUntil(const std::function<bool()>& done, double timeout_s = 10.0) {
    const ros::SteadyTime deadline = ros::SteadyTime::now() + ros::WallDuration(timeout_s);
    while (!done() && ros::SteadyTime::now() < deadline) {
      ros::spinOnce();
      ros::WallDuration(0.002).sleep();
    }
    return done();
  }

  void command(double speed_m_s, double yaw_rate_rad_s) {
    geometry_msgs::Twist twist;
    twist.linear.x = speed_m_s;
    twist.angular.z = yaw_rate_rad_s;
    commands_.publish(twist);
  }

  /// Commands ten times a second until something becomes true or real time runs out.
  bool driveUntil(double speed_m_s, double yaw_rate_rad_s, const std::function<bool()>& done) {
    ros::SteadyTime next;
    return spinUntil([&] {
      if (ros::SteadyTime::now() >= next) {
        next = ros::SteadyTime::now() + ros::WallDuration(0.1);
        command(speed_m_s, yaw_rate_rad_s);
      }
      return done();
    });
  }

  bool standsStill() const {
    constexpr std::size_t kPoses = 10;
    return poses_.size() > kPoses &&
           std::all_of(poses_.end() - kPoses, poses_.end(), [&](const Eigen::Isometry2d& pose) {
             return pose.isApprox(poses_.back(), 1e-9);
           });
  }

  Eigen::Vector2d position() const { return poses_.back().translation(); }

  /// Whether the cell of the truth at a point is free.
  bool isFree(const Eigen::Vector2d& point) const {
    const auto& info = truth_->info;
    const Eigen::Vector2d origin(info.origin.position.x, info.origin.position.y);
    const Eigen::Vector2d cell = (point - origin) / info.resolution;
    const bool inside = cell.minCoeff() >= 0.0 && cell.x() < info.width && cell.y() < info.height;
    return inside && truth_->data[static_cast<std::size_t>(cell.y()) * info.width +
                                  static_cast<std::size_t>(cell.x())] == 0;
  }

  /// Distance to the nearest cell that is not free [m].
  double clearance() const {
    const double cell_m = truth_->info.resolution;
    const Eigen::Vector2d origin(truth_->info.origin.position.x, truth_->info.origin.position.y);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < truth_->data.size(); ++i) {
      if (truth_->data[i] != 0) {
        const Eigen::Vector2d corner =
            origin + cell_m * Eigen::Vector2d(i % truth_->info.width, i / truth_->info.width);
        const Eigen::AlignedBox2d square(corner, corner + Eigen::Vector2d(cell_m, cell_m));
        nearest = std::min(nearest, square.exteriorDistance(position()));
      }
    }
    return nearest;
  }

  std::vector<bool> contacts_;
  std::vector<bool> finished_;
  std::vector<Eigen::Isometry2d> poses_;  // map_from_base
  std::size_t scans_ = 0;
  std::vector<sensor_msgs::LaserScan> laser_scans_;
  nav_msgs::Odometry odometry_;
  double fastest_m_s_ = 0.0;  // by odometry
  nav_msgs::OccupancyGridConstPtr truth_;

 private:
  void receiveTransforms(const tf2_msgs::TFMessage& message) {
    Eigen::Isometry2d map_from_base = Eigen::Isometry2d::Identity();
    for (const geometry_msgs::TransformStamped& link : message.transforms) {
      map_from_base.translate(
          Eigen::Vector2d(link.transform.translation.x, link.transform.translation.y));
      map_from_base.rotate(2.0 * std::atan2(link.transform.rotation.z, link.transform.rotation.w));
    }
    poses_.push_back(map_from_base);
  }
  void receiveContact(const std_msgs::Bool& message) { contacts_.push_back(message.data != 0); }
  void receiveFinished(const std_msgs::Bool& message) { finished_.push_back(message.data != 0); }
  void receiveOdometry(const nav_msgs::Odometry& message) {
    odometry_ = message;
    fastest_m_s_ = std::max(fastest_m_s_, message.twist.twist.linear.x);
  }
  void receiveLaserScan(const sensor_msgs::LaserScan& message) { laser_scans_.push_back(message); }
  void receiveTruth(const nav_msgs::OccupancyGridConstPtr& message) { truth_ = message; }
  void receiveScan(const structure_from_wifi::WifiScan&) { ++scans_; }

  ros::NodeHandle node_;
  ros::Publisher commands_;
  std::vector<ros::Subscriber> subscribers_;
};

TEST_F(Cockpit, TheRobotStandsAtTheRoutesStartUntilItIsTold) {
  EXPECT_NEAR((position() - Eigen::Vector2d(-0.4, 0.1)).norm(), 0.0, 1e-9);
  EXPECT_EQ(contacts_, std::vector<bool>{false});
  EXPECT_TRUE(spinUntil([this] { return scans_ > 3; })) << "it listens while it stands";
}

TEST_F(Cockpit, ItsLaserSeesTheWallsOfTheTruth) {
  ASSERT_TRUE(spinUntil([this] { return laser_scans_.size() > 2; }));
  const sensor_msgs::LaserScan& scan = laser_scans_.back();
  ASSERT_EQ(scan.ranges.size(), 720U);
  EXPECT_EQ(scan.header.frame_id, "base_link");
  EXPECT_NEAR((scan.header.stamp - laser_scans_.end()[-2].header.stamp).toSec(), 0.2, 1e-6);
  EXPECT_NEAR(scan.angle_max - scan.angle_min, 719 * scan.angle_increment, 1e-4);
  EXPECT_EQ(scan.range_max, 1.5F);
  // Each beam ends on the edge of a cell that is not free, or sees nothing.
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const float bearing = scan.angle_min + static_cast<float>(i) * scan.angle_increment;
    const Eigen::Vector2d direction(std::cos(bearing), std::sin(bearing));
    const double range = std::min(scan.ranges[i], scan.range_max);
    EXPECT_TRUE(isFree(poses_.back() * Eigen::Vector2d((range - 1e-3) * direction))) << i;
    if (std::isfinite(scan.ranges[i])) {
      EXPECT_FALSE(isFree(poses_.back() * Eigen::Vector2d((range + 1e-3) * direction))) << i;
    }
  }
}

TEST_F(Cockpit, ItStopsWhenCommandsStop) {
  const Eigen::Vector2d start = position();
  command(0.3, 0.0);
  ASSERT_TRUE(spinUntil([&] { return (position() - start).norm() > 0.01; }));
  ASSERT_TRUE(spinUntil([this] { return standsStill(); }));
  // Half a second at 0.3 m/s, less what speeding up takes and more what braking does.
  EXPECT_NEAR((position() - start).norm(), 0.15, 0.06);
  EXPECT_NEAR(position().x(), start.x(), 1e-9) << "it looks along y";
  EXPECT_NEAR(fastest_m_s_, 0.3, 0.01);
  EXPECT_EQ(odometry_.twist.twist.linear.x, 0.0);
  EXPECT_EQ(odometry_.child_frame_id, "base_link");
}

TEST_F(Cockpit, AWallStopsItAndIsFeltOnce) {
  ASSERT_TRUE(driveUntil(50.0, 0.0, [this] { return contacts_.back() && standsStill(); }));
  EXPECT_NEAR(clearance(), kRadius, 1e-5);
  EXPECT_GE(clearance(), kRadius - 1e-6);
  EXPECT_EQ(contacts_, (std::vector<bool>{false, true}));

  ASSERT_TRUE(driveUntil(-0.2, 0.0, [this] { return !contacts_.back(); }));
  EXPECT_GT(clearance(), kRadius);
}

TEST_F(Cockpit, AWallIsFeltAgainWhenItTurnsInTouch) {
  ASSERT_TRUE(driveUntil(0.5, 0.0, [this] { return contacts_.back() && standsStill(); }));
  const std::size_t before = contacts_.size();
  ASSERT_TRUE(driveUntil(0.2, 0.5, [&] { return contacts_.size() > before; }));
  EXPECT_TRUE(contacts_[before]);
  ASSERT_TRUE(driveUntil(-0.2, 0.0, [this] { return !contacts_.back(); }));
}

TEST_F(Cockpit, ItTurnsOnTheSpot) {
  const Eigen::Vector2d start = position();
  const Eigen::Matrix2d before = poses_.back().linear();
  ASSERT_TRUE(driveUntil(0.0, 1.0, [&] {
    return (before.transpose() * poses_.back().linear())(0, 0) < 0.0;  // by a right angle
  }));
  EXPECT_EQ(position(), start);
}

TEST_F(Cockpit, ItIgnoresCommandsThatAreNoNumbers) {
  const Eigen::Vector2d start = position();
  const std::size_t poses = poses_.size();
  command(std::numeric_limits<double>::quiet_NaN(), 0.0);
  command(0.0, std::numeric_limits<double>::infinity());
  ASSERT_TRUE(spinUntil([&] { return poses_.size() > poses + 20; }));
  EXPECT_EQ(position(), start);
  EXPECT_EQ(finished_, std::vector<bool>{false});
}

}  // namespace
}  // namespace sfw

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "cmd_vel_simulator_test");
  const ros::NodeHandle node;  // keeps ROS up between the tests
  return RUN_ALL_TESTS();
}
