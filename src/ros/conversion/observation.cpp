#include "ros/conversion/observation.h"

#include <sensor_msgs/point_cloud2_iterator.h>

#include <algorithm>

namespace sfw {
namespace {

ros::Time stampOr(const ros::Time& stamp, const ros::Time& now) {
  return stamp.isZero() ? now : stamp;
}

}  // namespace

std::vector<Observation> toObservations(const structure_from_wifi::WifiScan& scan,
                                        const ros::Time& now, std::size_t& malformed) {
  constexpr std::size_t kMostReadings = 1000;  // what a radio can hear is far less
  constexpr double kOldest = 3600.0;  // [s]; no cache of scans is older, and ros::Duration throws
  const std::size_t readings = std::min(scan.readings.size(), kMostReadings);
  malformed += scan.readings.size() - readings;
  const ros::Time heard = stampOr(scan.header.stamp, now);
  std::vector<Observation> observations;
  for (std::size_t i = 0; i < readings; ++i) {
    const structure_from_wifi::ApReading& reading = scan.readings[i];
    const std::optional<Bssid> bssid = Bssid::parse(reading.bssid);
    const double age = reading.age_s;
    if (!bssid || !(age >= 0.0 && age < std::min(kOldest, heard.toSec()))) {
      ++malformed;
      continue;
    }
    observations.push_back({heard - ros::Duration(age),
                            UnplacedReading{*bssid, static_cast<double>(reading.rssi_dbm)}});
  }
  return observations;
}

std::vector<Observation> toObservations(const wireless_msgs::Connection& connection,
                                        const ros::Time& now) {
  const std::optional<Bssid> bssid = Bssid::parse(connection.bssid);
  if (!bssid || connection.signal_level == 0) {
    return {};
  }
  return {{now, UnplacedReading{*bssid, static_cast<double>(connection.signal_level)}}};
}

Observation frontContact(const std::string& antenna_frame, double footprint_radius_m,
                         const ros::Time& now) {
  return {now, UnplacedContacts{antenna_frame, {{footprint_radius_m, 0.0, 0.0}}}};
}

Observation toObservation(const sensor_msgs::PointCloud2& cloud, const ros::Time& now) {
  constexpr float kFarthest = 2.0F;  // [m]
  UnplacedContacts contacts{cloud.header.frame_id, {}};
  sensor_msgs::PointCloud2ConstIterator<float> x(cloud, "x");
  sensor_msgs::PointCloud2ConstIterator<float> y(cloud, "y");
  sensor_msgs::PointCloud2ConstIterator<float> z(cloud, "z");
  for (; x != x.end(); ++x, ++y, ++z) {
    const Eigen::Vector3f point(*x, *y, *z);
    if (point.allFinite() && point.norm() <= kFarthest) {
      contacts.points.push_back(point.cast<double>());
    }
  }
  return {stampOr(cloud.header.stamp, now), std::move(contacts)};
}

}  // namespace sfw
