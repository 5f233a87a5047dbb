#include "ros/conversion/input_messages.h"

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>
#include <std_msgs/String.h>
#include <structure_from_wifi/WifiScan.h>
#include <tf2/buffer_core.h>
#include <wireless_msgs/Connection.h>

#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "any_message_of.h"
#include "ros/mapping/observation_queue.h"

namespace sfw {
namespace {

const InputContext kContext{ros::Time(100.0), "antenna", 0.2};

structure_from_wifi::ApReading apReading(const std::string& bssid, float rssi_dbm, double age_s) {
  structure_from_wifi::ApReading reading;
  reading.bssid = bssid;
  reading.rssi_dbm = rssi_dbm;
  reading.age_s = static_cast<float>(age_s);
  return reading;
}

TEST(InputMessages, HaveOneTopicEach) {
  std::set<std::string> topics;
  for (const Input& input : kInputs) {
    topics.insert(input.topic);
  }
  EXPECT_EQ(topics.size(), kInputs.size());
}

TEST(InputMessages, NameTheTypeThatATopicCannotHave) {
  for (const Input& input : kInputs) {
    const Conversion conversion = input.convert(anyMessageOf(std_msgs::String()), kContext);
    EXPECT_TRUE(conversion.observations.empty());
    EXPECT_EQ(conversion.rejected, 1U) << input.topic;
    EXPECT_NE(conversion.problem.find("type std_msgs/String"), std::string::npos) << input.topic;
  }
}

TEST(InputMessages, RejectBytesThatAreNoMessageOfTheType) {
  structure_from_wifi::WifiScan scan;
  scan.readings = {apReading("02:00:00:00:00:01", -40.0F, 0.0)};
  for (const int change : {-1, 1}) {
    AnyMessage message = anyMessageOf(scan);
    message.bytes.resize(message.bytes.size() + static_cast<std::size_t>(change));
    const Conversion conversion = convertReadings(message, kContext);
    EXPECT_EQ(conversion.rejected, 1U) << change;
    EXPECT_TRUE(conversion.observations.empty()) << change;
    EXPECT_NE(conversion.problem.find("cannot be read"), std::string::npos) << conversion.problem;
  }
}

TEST(InputMessages, RejectAnotherVersionOfAContact) {
  AnyMessage message = anyMessageOf(std_msgs::Bool());
  message.md5[0] = message.md5[0] == '0' ? '1' : '0';
  const Conversion conversion = convertAnyContact(message, kContext);
  EXPECT_EQ(conversion.rejected, 1U);
  EXPECT_NE(conversion.problem.find("another version"), std::string::npos) << conversion.problem;
}

TEST(InputMessages, MakeNoRoomForElementsThatDoNotCome) {
  AnyMessage message = anyMessageOf(sensor_msgs::PointCloud2());
  constexpr std::size_t kFieldCount = 4 + 8 + 4 + 4 + 4;  // after header, height and width
  message.bytes[kFieldCount + 2] = 0xff;                  // 16 million fields
  EXPECT_NE(convertAnyContactPoints(message, kContext).problem.find("cannot be read"),
            std::string::npos);
}

TEST(InputMessages, TakeALinkOnTheTopicOfScans) {
  wireless_msgs::Connection connection;
  connection.bssid = "02:00:00:00:00:01";
  connection.signal_level = -55;
  EXPECT_EQ(convertReadings(anyMessageOf(connection), kContext).observations.size(), 1U);
}

TEST(InputMessages, TakeEachReadingOfAScanAtItsOwnTime) {
  structure_from_wifi::WifiScan scan;
  scan.header.stamp = ros::Time(50.0);
  scan.readings = {apReading("02:00:00:00:00:01", -40.5F, 0.0),
                   apReading("02:00:00:00:00:02", -60.0F, 1.5)};
  const Conversion conversion = convertReadings(anyMessageOf(scan), kContext);
  EXPECT_EQ(conversion.problem, "");
  ASSERT_EQ(conversion.observations.size(), 2U);
  EXPECT_EQ(conversion.observations[0].stamp, ros::Time(50.0));
  EXPECT_EQ(conversion.observations[1].stamp, ros::Time(48.5));
  const auto& reading = std::get<UnlocatedReading>(conversion.observations[0].content);
  EXPECT_EQ(reading.bssid.str(), "02:00:00:00:00:01");
  EXPECT_EQ(reading.rssi_dbm, -40.5);
}

TEST(InputMessages, RejectMalformedReadingsOfAScan) {
  structure_from_wifi::WifiScan scan;
  for (const double age_s : {-1.0, 101.0, 1e30, std::nan("")}) {
    scan.readings.push_back(apReading("02:00:00:00:00:01", -40.0F, age_s));
  }
  scan.readings.push_back(apReading("not a bssid", -40.0F, 0.0));
  scan.readings.push_back(apReading("02:00:00:00:00:01", -40.0F, 0.0));
  const Conversion conversion = convertReadings(anyMessageOf(scan), kContext);
  ASSERT_EQ(conversion.observations.size(), 1U);
  EXPECT_EQ(conversion.observations[0].stamp, kContext.received);  // the scan has no stamp
  EXPECT_EQ(conversion.rejected, 5U);
  EXPECT_NE(conversion.problem, "");
}

TEST(InputMessages, TakeAtMost1000ReadingsOfAScan) {
  structure_from_wifi::WifiScan scan;
  scan.readings.assign(1200, apReading("02:00:00:00:00:01", -40.0F, 0.0));
  const Conversion conversion = convertReadings(anyMessageOf(scan), kContext);
  EXPECT_EQ(conversion.observations.size(), 1000U);
  EXPECT_EQ(conversion.rejected, 200U);
}

TEST(InputMessages, TakeTheLinkOfAnAssociatedRadio) {
  wireless_msgs::Connection connection;
  EXPECT_TRUE(convertReadings(anyMessageOf(connection), kContext).observations.empty());
  EXPECT_NE(convertReadings(anyMessageOf(connection), kContext).problem, "");
  connection.bssid = "02:00:00:00:00:01";
  connection.signal_level = -55;
  const Conversion conversion = convertReadings(anyMessageOf(connection), kContext);
  ASSERT_EQ(conversion.observations.size(), 1U);
  EXPECT_EQ(conversion.observations[0].stamp, kContext.received);
  EXPECT_EQ(std::get<UnlocatedReading>(conversion.observations[0].content).rssi_dbm, -55.0);
}

TEST(InputMessages, PutAContactAtTheRimOfTheRobot) {
  std_msgs::Bool contact;
  EXPECT_TRUE(convertContact(contact, kContext).observations.empty());
  contact.data = 1;
  const Conversion conversion = convertContact(contact, kContext);
  ASSERT_EQ(conversion.observations.size(), 1U);
  const auto& contacts = std::get<UnlocatedContacts>(conversion.observations[0].content);
  EXPECT_EQ(contacts.frame, "antenna");
  ASSERT_EQ(contacts.points.size(), 1U);
  EXPECT_EQ(contacts.points[0], Eigen::Vector3d(0.2, 0.0, 0.0));
}

TEST(InputMessages, RejectACloudWithoutCoordinates) {
  const Conversion conversion = convertContactPoints(sensor_msgs::PointCloud2(), kContext);
  EXPECT_TRUE(conversion.observations.empty());
  EXPECT_EQ(conversion.rejected, 1U);
  EXPECT_NE(conversion.problem, "");
}

/// Two points as a bumper's node sends them; the second is beyond the reach of bumpers.
sensor_msgs::PointCloud2 bumperCloud() {
  sensor_msgs::PointCloud2 cloud;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2FieldsByString(1, "xyz");
  modifier.resize(2);
  const std::array<float, 6> coordinates{0.5F, -0.25F, 0.125F, 100.0F, 0.0F, 0.0F};
  for (std::size_t point = 0; point < 2; ++point) {
    std::memcpy(cloud.data.data() + point * cloud.point_step, &coordinates[3 * point],
                3 * sizeof(float));
  }
  return cloud;
}

TEST(InputMessages, TakeTheNearPointsOfACloud) {
  const Conversion conversion = convertContactPoints(bumperCloud(), kContext);
  ASSERT_EQ(conversion.observations.size(), 1U);
  EXPECT_EQ(conversion.rejected, 0U);
  const auto& contacts = std::get<UnlocatedContacts>(conversion.observations[0].content);
  ASSERT_EQ(contacts.points.size(), 1U);
  EXPECT_EQ(contacts.points[0], Eigen::Vector3d(0.5, -0.25, 0.125));
}

TEST(InputMessages, TakeAnEmptyCloudOfManyRowsAtOnce) {
  sensor_msgs::PointCloud2 cloud = bumperCloud();
  cloud.width = 0;
  cloud.height = 4294967295U;
  EXPECT_EQ(convertContactPoints(cloud, kContext).rejected, 0U);
}

TEST(InputMessages, RejectACloudWhoseSizesContradictItsData) {
  const std::vector<std::function<void(sensor_msgs::PointCloud2&)>> faults{
      [](auto& cloud) { cloud.data.pop_back(); },
      [](auto& cloud) { cloud.data.clear(); },
      [](auto& cloud) { cloud.width = cloud.height = 4294967295U; },
      [](auto& cloud) { cloud.point_step = 0; },
      [](auto& cloud) { cloud.point_step = 7; },
      [](auto& cloud) { cloud.fields[1].offset = 4294967295U; },
      [](auto& cloud) { cloud.fields[2].datatype = sensor_msgs::PointField::FLOAT64; },
      [](auto& cloud) { cloud.is_bigendian = 1; }};
  for (std::size_t i = 0; i < faults.size(); ++i) {
    sensor_msgs::PointCloud2 cloud = bumperCloud();
    faults[i](cloud);
    const Conversion conversion = convertContactPoints(cloud, kContext);
    EXPECT_TRUE(conversion.observations.empty()) << "fault " << i;
    EXPECT_EQ(conversion.rejected, 1U) << "fault " << i;
    EXPECT_NE(conversion.problem, "") << "fault " << i;
  }
}

TEST(InputMessages, TellOfALeadingSlashInTheFrameOfAScanAndTakeItsReadings) {
  structure_from_wifi::WifiScan scan;
  scan.readings = {apReading("02:00:00:00:00:01", -40.0F, 0.0)};
  for (const std::string frame : {"", "antenna"}) {
    scan.header.frame_id = frame;
    EXPECT_EQ(convertReadings(anyMessageOf(scan), kContext).problem, "");
  }
  scan.header.frame_id = "/antenna";
  const Conversion conversion = convertReadings(anyMessageOf(scan), kContext);
  EXPECT_EQ(conversion.problem,
            "frames of tf2 have no leading slash; '/antenna' is taken as 'antenna'");
  EXPECT_EQ(conversion.observations.size(), 1U);
  EXPECT_EQ(conversion.rejected, 0U);
  scan.readings.push_back(apReading("no address", -40.0F, 0.0));
  EXPECT_EQ(convertReadings(anyMessageOf(scan), kContext).problem, "a BSSID is malformed");
}

TEST(InputMessages, TheFrameOfAScanNamesItsRobot) {
  InputContext context = kContext;
  context.antenna_frames = {"robot1/wifi", "robot2/wifi"};
  structure_from_wifi::WifiScan scan;
  scan.readings = {apReading("02:00:00:00:00:01", -40.0F, 0.0)};
  const auto robotIn = [&](const std::string& frame) {
    scan.header.frame_id = frame;
    return convertReadings(anyMessageOf(scan), context).observations.at(0).robot;
  };
  EXPECT_EQ(robotIn("robot1/wifi"), "robot1/wifi");
  EXPECT_EQ(robotIn("/robot2/wifi"), "robot2/wifi");
  EXPECT_EQ(robotIn(""), "robot1/wifi");
  wireless_msgs::Connection without_header;
  without_header.bssid = "02:00:00:00:00:01";
  without_header.signal_level = -50;
  EXPECT_EQ(convertReadings(anyMessageOf(without_header), context).observations.at(0).robot,
            "robot1/wifi");
  scan.header.frame_id = "robot3/wifi";
  const Conversion strange = convertReadings(anyMessageOf(scan), context);
  EXPECT_TRUE(strange.observations.empty());
  EXPECT_EQ(strange.rejected, 1U);
  EXPECT_EQ(strange.problem, "the frame of a scan, 'robot3/wifi', is none of ros/antenna_frames");
  context.antenna_frames = {"robot1/wifi"};
  EXPECT_EQ(convertReadings(anyMessageOf(scan), context).observations.at(0).robot, "")
      << "one robot has any frame";
}

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

Observation observationAt(double seconds) {
  return {ros::Time(seconds), UnlocatedReading{*Bssid::parse("02:00:00:00:00:01"), -50.0}};
}

TEST(ObservationQueue, LocatesWhatTfKnowsAndKeepsTheRest) {
  tf2::BufferCore transforms;
  transforms.setTransform(mapFromAntenna(10.0, 1.0), "test");
  transforms.setTransform(mapFromAntenna(11.0, 3.0), "test");
  ObservationQueue queue(rosConfig());
  queue.push(observationAt(12.0));
  queue.push(observationAt(10.5));
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
    queue.push(observationAt(seconds));
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
  const Observation percent{ros::Time(10.0),
                            UnlocatedReading{*Bssid::parse("02:00:00:00:00:01"), 70.0}};
  for (int i = 0; i < 20; ++i) {
    queue.push(observationAt(10.0 + 0.01 * i));
  }
  for (int i = 0; i < 1000; ++i) {
    queue.push(percent);
  }
  const auto unexpected = [](const LocatedObservation&) { FAIL() << "tf knows no transform"; };
  const ObservationQueue::Outcome flooded =
      queue.locate(no_transforms, ros::Time(11.0), unexpected);
  EXPECT_EQ(flooded.overflowed, 0U);
  EXPECT_EQ(flooded.unusable, 998U);
  EXPECT_EQ(queue.size(), 22U);
  queue.push(observationAt(11.0));  // after a call of locate() the counts hold, too
  queue.push(percent);
  const ObservationQueue::Outcome later = queue.locate(no_transforms, ros::Time(11.0), unexpected);
  EXPECT_EQ(later.overflowed, 1U);
  EXPECT_EQ(later.unusable, 1U);
}

TEST(ObservationQueue, AnOldUnusableObservationGoesWithTheOldestUsableOne) {
  const tf2::BufferCore no_transforms;
  ObservationQueue queue(rosConfig());  // two may wait
  queue.push({ros::Time(10.0), UnlocatedReading{*Bssid::parse("02:00:00:00:00:01"), 70.0}});
  for (const double seconds : {10.0, 11.0, 12.0}) {
    queue.push(observationAt(seconds));
  }
  const auto unexpected = [](const LocatedObservation&) { FAIL() << "tf knows no transform"; };
  const ObservationQueue::Outcome outcome =
      queue.locate(no_transforms, ros::Time(12.0), unexpected);
  EXPECT_EQ(outcome.overflowed, 1U);
  EXPECT_EQ(outcome.unusable, 1U);
  EXPECT_EQ(queue.size(), 2U);
}

}  // namespace
}  // namespace sfw
