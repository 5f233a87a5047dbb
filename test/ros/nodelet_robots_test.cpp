// Several robots with trees of their own in tf, and one mapping nodelet.

#include <gtest/gtest.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/point_cloud2_iterator.h>
#include <std_msgs/Bool.h>
#include <structure_from_wifi/LoadMap.h>
#include <wireless_msgs/Connection.h>

#include <cmath>
#include <map>

#include "nodelet_diagnostics_world.h"
#include "structure_from_wifi/types.h"

namespace sfw {
namespace {

using Rows = std::vector<std::string>;

class NodeletRobotsTest : public NodeletDiagnosticsWorld {
 protected:
  static constexpr int kScans = 80;
  static constexpr double kStep = 0.05;  // [m] and [s]
  const Rows kRobots{"robot1", "robot2"};

  void SetUp() override {
    NodeletDiagnosticsWorld::SetUp();
    ros::param::set(name_ + "/mapping/ros/antenna_frames", "robot1/base_link /robot2/base_link");
  }

  /// Both drive along x, 4 m beside one another.
  static Position wayAt(const std::string& robot, int i) {
    return {kStep * i, robot == "robot1" ? 1.0 : 5.0};
  }

  /// tf of a robot whose odometry began at its own place.
  void sendTree(const std::string& robot, int i) {
    const Position start = wayAt(robot, 0);
    tf2_msgs::TFMessage message;
    message.transforms = {
        transform(kStep * i, "map", robot + "/odom", start.x(), start.y()),
        transform(kStep * i, robot + "/odom", robot + "/base_link", kStep * i, 0.0),
        transform(kStep * i, robot + "/base_link", robot + "/bumper", 0.2, 0.0)};
    transforms_.publish(message);
  }

  void sendScanOf(const std::string& frame, int i, const Readings& readings) {
    structure_from_wifi::WifiScan scan = scanOf(readings);
    scan.header.frame_id = frame;
    scan.header.stamp = at(kStep * i);
    scans_.publish(scan);
  }

  void driveBoth() {
    for (int i = 0; i < kScans; ++i) {
      for (const std::string& robot : kRobots) {
        sendTree(robot, i);
        sendScanOf(robot + "/base_link", i, {{kNear, -50.0F - static_cast<float>(i % 7)}});
      }
    }
  }

  /// The rows of a saved file, once there are so many.
  Rows rowsOf(const std::string& file, std::size_t expected) {
    Rows found;
    spinUntil(
        [&] {
          found.clear();
          std::istringstream text(savedFile(file));
          std::string line;
          std::getline(text, header_);
          while (std::getline(text, line)) {
            found.push_back(line);
          }
          return found.size() >= expected;
        },
        30.0 * kSlowdown);
    return found;
  }

  static Rows fieldsOf(const std::string& row) {
    std::istringstream text(row);
    Rows fields;
    for (std::string field; std::getline(text, field, ',');) {
      fields.push_back(field);
    }
    return fields;
  }

  std::string header_;
};

TEST_F(NodeletRobotsTest, MakeOneMapFromTwoTreesOfTf) {
  load();
  driveBoth();
  const Rows rows = rowsOf("readings.csv", 2 * kScans);
  ASSERT_EQ(rows.size(), std::size_t{2 * kScans});
  EXPECT_EQ(header_, "stamp,x,y,bssid,rssi_dbm,robot");
  std::map<std::string, int> count;
  for (const std::string& row : rows) {
    const Rows fields = fieldsOf(row);
    ASSERT_EQ(fields.size(), 6U) << row;
    const std::string robot = fields[5].substr(0, fields[5].find('/'));
    const int i = static_cast<int>(std::lround((std::stod(fields[0]) - start_.toSec()) / kStep));
    EXPECT_NEAR(std::stod(fields[1]), wayAt(robot, i).x(), 1e-4) << row;
    EXPECT_NEAR(std::stod(fields[2]), wayAt(robot, i).y(), 1e-4) << row;
    ++count[fields[5]];
  }
  EXPECT_EQ(count, (std::map<std::string, int>{{"robot1/base_link", kScans},
                                               {"robot2/base_link", kScans}}));
  EXPECT_EQ(logged(rosgraph_msgs::Log::WARN, "in two places"), 0);
  EXPECT_TRUE(hasValue("map", "stray poses", "0"));

  const std::string before = savedFile("readings.csv");
  const structure_from_wifi::SaveMap::Response saved = save("both");
  ASSERT_TRUE(saved.success) << saved.message;
  structure_from_wifi::LoadMap load_map;
  load_map.request.directory = "both";
  ASSERT_TRUE(callService(name_ + "/mapping/load_map", load_map));
  ASSERT_TRUE(load_map.response.success) << load_map.response.message;
  EXPECT_EQ(savedFile("readings.csv"), before) << "a session merges robot by robot";
}

TEST_F(NodeletRobotsTest, AScanOfNoRobotIsLeftOutAndTold) {
  load();
  sendTree("robot1", 0);
  sendTree("robot2", 0);
  sendScanOf("robot3/base_link", 0, {{kNear, -50.0F}});
  EXPECT_TRUE(logs(rosgraph_msgs::Log::WARN, "'robot3/base_link', is none of ros/antenna_frames"));
  sendScanOf("", 0, {{kNear, -60.0F}});
  EXPECT_TRUE(logs(rosgraph_msgs::Log::WARN,
                   "wifi_scan: a message without a frame does not name its robot"));
  sendScanOf("robot2/base_link", 0, {{kNear, -70.0F}});
  const Rows rows = rowsOf("readings.csv", 1);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(fieldsOf(rows[0]).back(), "robot2/base_link");
}

TEST_F(NodeletRobotsTest, AMessageWithoutAFrameIsOfTheRobotOfItsTopic) {
  ros::NodeHandle node;
  const ros::Publisher shared = node.advertise<std_msgs::Bool>(name_ + "/contact", 10);
  const ros::Publisher bumper = node.advertise<std_msgs::Bool>(name_ + "/robot2/contact", 10);
  const ros::Publisher link =
      node.advertise<wireless_msgs::Connection>(name_ + "/robot2/connection", 10);
  load();
  ASSERT_TRUE(spinUntil(
      [&] {
        return shared.getNumSubscribers() > 0 && bumper.getNumSubscribers() > 0 &&
               link.getNumSubscribers() > 0;
      },
      30.0));
  for (int i = 0; i < 2; ++i) {
    sendTree("robot1", i);
    sendTree("robot2", i);
  }
  std_msgs::Bool touch;
  touch.data = 1;
  shared.publish(touch);
  EXPECT_TRUE(logs(rosgraph_msgs::Log::WARN,
                   "contact: a message without a frame does not name its robot; publish it in the "
                   "namespace of its robot, robot1 or robot2"));
  bumper.publish(touch);
  wireless_msgs::Connection connection;
  connection.bssid = kNear;
  connection.signal_level = -50;
  link.publish(connection);
  const Rows readings = rowsOf("readings.csv", 1);
  ASSERT_EQ(readings.size(), 1U);
  EXPECT_EQ(fieldsOf(readings[0]).back(), "robot2/base_link");
  const Rows contacts = rowsOf("contacts.csv", 1);
  ASSERT_EQ(contacts.size(), 1U);
  const Rows fields = fieldsOf(contacts[0]);
  EXPECT_EQ(fields.back(), "robot2/base_link");
  EXPECT_NEAR(std::stod(fields[2]), 5.0, 1e-4);
  EXPECT_TRUE(hasValue("inputs",
                       name_ + "/contact: rejected: a message without a frame does not name its "
                               "robot; publish it in the namespace of its robot, robot1 or robot2",
                       "1"));
}

TEST_F(NodeletRobotsTest, ContactsBelongToTheRobotOfTheirTree) {
  ros::Publisher clouds =
      ros::NodeHandle().advertise<sensor_msgs::PointCloud2>(name_ + "/contact_points", 10);
  load();
  ASSERT_TRUE(spinUntil([&] { return clouds.getNumSubscribers() > 0; }, 30.0));
  driveBoth();
  sensor_msgs::PointCloud2 cloud;
  cloud.header.frame_id = "robot2/bumper";
  cloud.header.stamp = at(kStep * (kScans - 1));
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2FieldsByString(1, "xyz");
  modifier.resize(1);
  sensor_msgs::PointCloud2Iterator<float> x(cloud, "x");
  x[0] = x[1] = x[2] = 0.0F;
  clouds.publish(cloud);
  ASSERT_EQ(rowsOf("readings.csv", 2 * kScans).size(), std::size_t{2 * kScans});
  const Rows contacts = rowsOf("contacts.csv", 1);
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(header_, "stamp,x,y,robot");
  const Rows fields = fieldsOf(contacts[0]);
  EXPECT_EQ(fields.back(), "robot2/base_link");
  EXPECT_NEAR(std::stod(fields[1]), kStep * (kScans - 1) + 0.2, 1e-4);
  EXPECT_NEAR(std::stod(fields[2]), 5.0, 1e-4);
}

TEST_F(NodeletRobotsTest, ARobotWithoutTransformIsNamed) {
  load();
  for (int i = 0; i < 3; ++i) {
    sendTree("robot1", i);
  }
  EXPECT_TRUE(hears("transforms", diagnostic_msgs::DiagnosticStatus::ERROR,
                    "tf has no frame robot2/base_link"));
}

}  // namespace
}  // namespace sfw

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "nodelet_robots_test");
  const ros::NodeHandle node;  // keeps ROS alive
  return RUN_ALL_TESTS();
}
