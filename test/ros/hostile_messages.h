#pragma once

#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/point_cloud2_iterator.h>
#include <structure_from_wifi/WifiScan.h>
#include <tf2_msgs/TFMessage.h>
#include <wireless_msgs/Connection.h>

#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <variant>
#include <vector>

namespace sfw {

/// Messages of broken drivers, clocks and transforms, one kind after the other. None of them holds
/// anything that may change a map.
class HostileMessages {
 public:
  using Message = std::variant<structure_from_wifi::WifiScan, wireless_msgs::Connection,
                               sensor_msgs::PointCloud2, tf2_msgs::TFMessage>;

  /// @param known  BSSID of an access point of the table
  HostileMessages(const std::string& known, std::uint64_t seed) : known_(known), random_(seed) {}

  /// @param now  of the clock of the stamps
  Message next(const ros::Time& now) {
    constexpr int kKinds = 4;
    switch (count_++ % kKinds) {
      case 0:
        return scan(now);
      case 1:
        return connection();
      case 2:
        return cloud(now);
      default:
        return transform(now);
    }
  }

 private:
  static constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  static constexpr float kInfinity = std::numeric_limits<float>::infinity();

  template <class Value>
  const Value& anyOf(const std::vector<Value>& values) {
    return values[random_() % values.size()];
  }

  structure_from_wifi::ApReading reading(const std::string& bssid, float rssi_dbm, float age_s) {
    structure_from_wifi::ApReading reading;
    reading.bssid = bssid;
    reading.ssid = anyOf<std::string>({"home", "", "\xff\xfe", std::string(32, '\0')});
    reading.rssi_dbm = rssi_dbm;
    reading.frequency_mhz = anyOf<float>({2437.0F, 0.0F, kNan, -1.0F, kInfinity});
    reading.age_s = age_s;
    return reading;
  }

  structure_from_wifi::ApReading noSignal() {
    // Percents and sentinels are positive, or beyond what a radio can hear.
    return reading(known_,
                   anyOf<float>({kNan, kInfinity, -kInfinity, 70.0F, 100.0F, 127.0F, 1.0F, -120.0F,
                                 -128.0F, -1000.0F, 1e30F}),
                   0.0F);
  }

  structure_from_wifi::ApReading noAddress() {
    return reading(anyOf<std::string>({"", "02:00:00:00:00", "02:00:00:00:00:0g",
                                       "00:00:00:00:00:00", "02:00:00:00:00:01:02",
                                       std::string(100'000, 'f'), std::string(17, '\0')}),
                   -50.0F, 0.0F);
  }

  structure_from_wifi::ApReading noAge() {
    return reading(known_, -50.0F, anyOf<float>({kNan, kInfinity, -1.0F, 1e9F, 3e9F, 1e30F}));
  }

  structure_from_wifi::WifiScan scan(const ros::Time& now) {
    structure_from_wifi::WifiScan scan;
    scan.header.frame_id = anyOf<std::string>({"", "/base_link", "nowhere"});
    scan.header.stamp = now;
    switch (random_() % 7) {
      case 0:
        break;  // empty
      case 1:
        scan.readings = {noSignal(), noAddress(), noAge()};
        break;
      case 2:
        scan.header.stamp = ros::Time();
        scan.readings = {noSignal()};
        break;
      case 3:  // older than any transform that is kept
        scan.header.stamp = anyOf<ros::Time>({ros::Time(1e-9), ros::Time(1.0), now - kLongAgo});
        scan.readings = {reading(known_, -50.0F, 0.0F)};
        break;
      case 4:
        scan.header.stamp = anyOf<ros::Time>({ros::Time(4e9), now + kLongAgo});
        scan.readings = {reading(known_, -50.0F, 0.0F)};
        break;
      case 5:
        scan.readings.assign(10'000, noSignal());
        break;
      default:
        scan.readings.assign(10'000, noAddress());
    }
    return scan;
  }

  /// Of a radio without a link, as drivers tell it.
  wireless_msgs::Connection connection() {
    wireless_msgs::Connection connection;
    connection.bssid = anyOf<std::string>({"", known_, "Not-Associated", "none"});
    connection.signal_level =
        connection.bssid == known_
            ? anyOf<std::int16_t>({0, 70, 100, 200, -120, -256, 32767, -32768})
            : anyOf<std::int16_t>({0, -50});
    connection.frequency = anyOf<double>({0.0, 2.437, std::numeric_limits<double>::quiet_NaN()});
    return connection;
  }

  sensor_msgs::PointCloud2 cloud(const ros::Time& now) {
    sensor_msgs::PointCloud2 cloud;
    sensor_msgs::PointCloud2Modifier modifier(cloud);
    modifier.setPointCloud2FieldsByString(1, "xyz");
    modifier.resize(3);
    cloud.header.frame_id = "base_link";
    cloud.header.stamp = now;
    switch (random_() % 8) {
      case 0:
        cloud.data.resize(cloud.data.size() - 5);
        break;
      case 1:
        cloud.data.clear();
        break;
      case 2:
        cloud.width = cloud.height = std::numeric_limits<std::uint32_t>::max();
        break;
      case 3:
        cloud.point_step = anyOf<std::uint32_t>({0, 1, 4, 0xffffffffU});
        break;
      case 4:
        cloud.fields[1].offset = anyOf<std::uint32_t>({13, 1'000'000, 0xffffffffU});
        break;
      case 5:
        cloud.fields.clear();
        break;
      case 6:
        cloud.header.frame_id = anyOf<std::string>({"nowhere", "", "/base_link/"});
        break;
      default:
        for (sensor_msgs::PointCloud2Iterator<float> x(cloud, "x"); x != x.end(); ++x) {
          *x = anyOf<float>({kNan, kInfinity, -kInfinity, 1e30F});
        }
    }
    return cloud;
  }

  tf2_msgs::TFMessage transform(const ros::Time& now) {
    tf2_msgs::TFMessage message;
    geometry_msgs::TransformStamped broken;
    broken.header.frame_id = "map";
    broken.header.stamp = now;
    broken.child_frame_id = "base_link";
    broken.transform.rotation.w = 1.0;
    switch (random_() % 5) {
      case 0:
        // tf2 keeps an infinite one; then readings up to its neighbours have no place.
        broken.transform.translation.x = kNan;
        break;
      case 1:
        broken.transform.rotation.z = anyOf<double>({kNan, kInfinity, 0.5});
        break;
      case 2:
        broken.transform.rotation.w = anyOf<double>({0.0, 2.0, kNan});
        break;
      case 3:
        broken.header.frame_id = anyOf<std::string>({"", "base_link"});
        break;
      default:
        broken.child_frame_id = "";
    }
    message.transforms = {broken};
    return message;
  }

  inline static const ros::Duration kLongAgo{500.0};

  std::string known_;
  std::mt19937_64 random_;
  std::uint64_t count_ = 0;
};

}  // namespace sfw
