#include "ros/conversion/input_messages.h"

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>
#include <std_msgs/String.h>
#include <structure_from_wifi/WifiScan.h>
#include <wireless_msgs/Connection.h>

#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "any_message_of.h"

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

/// What a conversion left out.
std::size_t countOf(const Conversion& conversion) {
  std::size_t sum = 0;
  for (const auto& [reason, count] : conversion.rejected) {
    sum += count;
  }
  return sum;
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
    EXPECT_EQ(countOf(conversion), 1U) << input.topic;
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
    EXPECT_EQ(countOf(conversion), 1U) << change;
    EXPECT_TRUE(conversion.observations.empty()) << change;
    EXPECT_NE(conversion.problem.find("cannot be read"), std::string::npos) << conversion.problem;
  }
}

TEST(InputMessages, RejectAnotherVersionOfAContact) {
  AnyMessage message = anyMessageOf(std_msgs::Bool());
  message.md5[0] = message.md5[0] == '0' ? '1' : '0';
  const Conversion conversion = convertAnyContact(message, kContext);
  EXPECT_EQ(countOf(conversion), 1U);
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
  scan.readings.push_back(apReading("nor this", -40.0F, 0.0));
  scan.readings.push_back(apReading("02:00:00:00:00:01", -40.0F, 0.0));
  const Conversion conversion = convertReadings(anyMessageOf(scan), kContext);
  ASSERT_EQ(conversion.observations.size(), 1U);
  EXPECT_EQ(conversion.observations[0].stamp, kContext.received);  // the scan has no stamp
  using Counts = std::map<std::string, std::size_t>;
  EXPECT_EQ(conversion.rejected,
            (Counts{{"a reading has no usable time or age", 4}, {"a BSSID is malformed", 2}}));
  EXPECT_EQ(conversion.problem, "a reading has no usable time or age") << "the first one";
}

TEST(InputMessages, TakeAtMost10000ReadingsOfAScanAndCountTheOthersApart) {
  structure_from_wifi::WifiScan scan;
  scan.readings.assign(1500, apReading("02:00:00:00:00:01", -40.0F, 0.0));
  const Conversion large = convertReadings(anyMessageOf(scan), kContext);
  EXPECT_EQ(large.observations.size(), 1500U);
  EXPECT_TRUE(large.rejected.empty());
  scan.readings.assign(10200, apReading("02:00:00:00:00:01", -40.0F, 0.0));
  scan.readings.front().bssid = "no address";
  const Conversion huge = convertReadings(anyMessageOf(scan), kContext);
  EXPECT_EQ(huge.observations.size(), kMostReadings);
  EXPECT_EQ(huge.rejected.at("a BSSID is malformed"), 1U);
  EXPECT_EQ(huge.rejected.at("the message has more than 10000 readings"), 199U);
}

TEST(InputMessages, TellANullInJsonFromTooManyReadings) {
  std_msgs::String text;
  text.data = R"({"data": [null, {"mac": "02:00:00:00:00:01", "rssi": -50, "type": "WiFi"}]})";
  const Conversion conversion = convertReadings(anyMessageOf(text), kContext);
  EXPECT_EQ(conversion.observations.size(), 1U);
  EXPECT_EQ(conversion.problem, "a BSSID is malformed");
}

TEST(InputMessages, KeepNoMoreOfManyListsThanOfOne) {
  AnyMessage message;
  message.type = "smd_wifi_monitor/WifiStatus";
  message.definition = "Device[] devices\n" + std::string(80, '=') +
                       "\nMSG: smd_wifi_monitor/Device\nStation[] stations\n" +
                       std::string(80, '=') +
                       "\nMSG: smd_wifi_monitor/Station\nuint8[6] bssid\nint8 signal\n";
  constexpr std::uint32_t kDevices = 60, kStations = 500;
  const auto append = [&](std::uint32_t count) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(&count);
    message.bytes.insert(message.bytes.end(), bytes, bytes + sizeof count);
  };
  append(kDevices);
  for (std::uint32_t device = 0; device < kDevices; ++device) {
    append(kStations);
    for (std::uint32_t station = 0; station < kStations; ++station) {
      const std::array<std::uint8_t, 7> bytes{2, 0, 0, 0, 0, 1, static_cast<std::uint8_t>(-50)};
      message.bytes.insert(message.bytes.end(), bytes.begin(), bytes.end());
    }
  }
  const Conversion conversion = convertReadings(message, kContext);
  EXPECT_EQ(conversion.observations.size(), kMostReadings);
  EXPECT_EQ(conversion.rejected.size(), 1U);
  EXPECT_GT(conversion.rejected.at("the message has more than 10000 readings"), 10000U)
      << "each of the last lists, which are not kept, counts once";
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
  EXPECT_EQ(countOf(conversion), 1U);
  EXPECT_NE(conversion.problem, "");
}

/// Two points as a bumper's node sends them; the second is beyond the reach of bumpers.
sensor_msgs::PointCloud2 bumperCloud() {
  sensor_msgs::PointCloud2 cloud;
  cloud.header.frame_id = "bumper";
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
  EXPECT_EQ(countOf(conversion), 0U);
  const auto& contacts = std::get<UnlocatedContacts>(conversion.observations[0].content);
  ASSERT_EQ(contacts.points.size(), 1U);
  EXPECT_EQ(contacts.points[0], Eigen::Vector3d(0.5, -0.25, 0.125));
}

TEST(InputMessages, TakeAnEmptyCloudOfManyRowsAtOnce) {
  sensor_msgs::PointCloud2 cloud = bumperCloud();
  cloud.width = 0;
  cloud.height = 4294967295U;
  EXPECT_EQ(convertContactPoints(cloud, kContext).problem, "");
}

TEST(InputMessages, RejectACloudWithoutFrame) {
  for (const std::string frame : {"", "/"}) {
    sensor_msgs::PointCloud2 cloud = bumperCloud();
    cloud.header.frame_id = frame;
    const Conversion conversion = convertContactPoints(cloud, kContext);
    EXPECT_TRUE(conversion.observations.empty());
    EXPECT_EQ(conversion.problem, "the cloud of contact points cannot be read: it has no frame_id");
  }
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
    EXPECT_EQ(countOf(conversion), 1U) << "fault " << i;
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
  EXPECT_EQ(countOf(conversion), 0U);
  scan.readings.push_back(apReading("no address", -40.0F, 0.0));
  EXPECT_EQ(convertReadings(anyMessageOf(scan), kContext).problem, "a BSSID is malformed");
}

/// Of two robots, on the topic of one, or of both if the frame is empty.
InputContext contextOfTwo(const std::string& antenna_frame) {
  InputContext context = kContext;
  context.antenna_frame = antenna_frame;
  context.antenna_frames = {"robot1/wifi", "robot2/wifi"};
  return context;
}

TEST(InputMessages, TheFrameOfAScanNamesItsRobot) {
  structure_from_wifi::WifiScan scan;
  scan.readings = {apReading("02:00:00:00:00:01", -40.0F, 0.0),
                   apReading("02:00:00:00:00:02", -40.0F, 0.0)};
  const auto conversionIn = [&](const std::string& frame) {
    scan.header.frame_id = frame;
    return convertReadings(anyMessageOf(scan), contextOfTwo(""));
  };
  EXPECT_EQ(conversionIn("robot1/wifi").observations.at(0).robot, "robot1/wifi");
  EXPECT_EQ(conversionIn("/robot2/wifi").observations.at(1).robot, "robot2/wifi");
  const Conversion strange = conversionIn("/robot3/wifi");
  EXPECT_TRUE(strange.observations.empty());
  EXPECT_EQ(countOf(strange), 2U);
  EXPECT_EQ(strange.problem, "the frame of a scan, 'robot3/wifi', is none of ros/antenna_frames");
  InputContext alone = kContext;
  alone.antenna_frames = {"robot1/wifi"};
  EXPECT_EQ(convertReadings(anyMessageOf(scan), alone).observations.at(0).robot, "")
      << "one robot has any frame";
}

TEST(InputMessages, TheTopicNamesTheRobotOfAMessageWithoutAFrame) {
  wireless_msgs::Connection link;
  link.bssid = "02:00:00:00:00:01";
  link.signal_level = -50;
  std_msgs::Bool contact;
  contact.data = 1;
  const Conversion reading = convertReadings(anyMessageOf(link), contextOfTwo("robot2/wifi"));
  EXPECT_EQ(reading.observations.at(0).robot, "robot2/wifi");
  const Conversion touch = convertContact(contact, contextOfTwo("robot2/wifi"));
  EXPECT_EQ(std::get<UnlocatedContacts>(touch.observations.at(0).content).frame, "robot2/wifi");
  for (const Conversion& nameless : {convertReadings(anyMessageOf(link), contextOfTwo("")),
                                     convertContact(contact, contextOfTwo(""))}) {
    EXPECT_TRUE(nameless.observations.empty());
    EXPECT_EQ(countOf(nameless), 1U);
    EXPECT_EQ(nameless.problem,
              "a message without a frame does not name its robot; publish it in the namespace of "
              "its robot, robot1 or robot2");
  }
}

TEST(InputMessages, TheFrameOfAScanCountsMoreThanItsTopic) {
  structure_from_wifi::WifiScan scan;
  scan.readings = {apReading("02:00:00:00:00:01", -40.0F, 0.0)};
  scan.header.frame_id = "robot1/wifi";
  const auto robot = [&] {
    return convertReadings(anyMessageOf(scan), contextOfTwo("robot2/wifi"))
        .observations.at(0)
        .robot;
  };
  EXPECT_EQ(robot(), "robot1/wifi");
  scan.header.frame_id = "wlan0";
  EXPECT_EQ(robot(), "robot2/wifi");
}

}  // namespace
}  // namespace sfw
