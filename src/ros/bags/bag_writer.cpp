#include "ros/bags/bag_writer.h"

#include <rosbag/bag.h>
#include <structure_from_wifi/WifiScan.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <cstdio>

#include "ros/conversion/message_conversion.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

ros::Time toTime(std::int64_t stamp_ns) {
  ros::Time stamp;
  stamp.fromNSec(static_cast<std::uint64_t>(stamp_ns));
  return stamp;
}

using Readings = std::vector<Reading>;

/// Writes the transforms and the scan of all readings of one stamp.
void writeScan(rosbag::Bag& bag, Readings::const_iterator begin, Readings::const_iterator end,
               const RosSettings& frames) {
  const ros::Time stamp = toTime(begin->stamp_ns);
  const std::string odom = frames.odom_frame.empty() ? "odom" : frames.odom_frame;
  tf2_msgs::TFMessage tf;
  tf.transforms = {
      toPlanarTransform(stamp, frames.map_frame, odom, Position::Zero(), 0.0),
      toPlanarTransform(stamp, odom, frames.antenna_frame, begin->antenna_in_map, 0.0)};
  bag.write("/tf", stamp, tf);
  structure_from_wifi::WifiScan scan;
  scan.header.stamp = stamp;
  scan.header.frame_id = frames.antenna_frame;
  for (auto reading = begin; reading != end; ++reading) {
    structure_from_wifi::ApReading message;
    message.bssid = reading->bssid.str();
    message.rssi_dbm = static_cast<float>(reading->rssi_dbm);
    scan.readings.push_back(message);
  }
  bag.write("/wifi_scan", stamp, scan);
}

}  // namespace

void writeBag(const std::string& file, const SimulatedRecording& recording,
              const RosSettings& frames) {
  const std::string unfinished = file + ".active";  // as rosbag record names it
  try {
    rosbag::Bag bag(unfinished, rosbag::bagmode::Write);
    const Readings& readings = recording.readings;
    for (auto begin = readings.begin(); begin != readings.end();) {
      const auto end = std::find_if(begin, readings.end(), [begin](const Reading& reading) {
        return reading.stamp_ns != begin->stamp_ns;
      });
      writeScan(bag, begin, end, frames);
      begin = end;
    }
    bag.close();
  } catch (const rosbag::BagException& error) {
    std::remove(unfinished.c_str());
    throw InputError(file + ": cannot be written: " + error.what());
  }
  if (std::rename(unfinished.c_str(), file.c_str()) != 0) {
    std::remove(unfinished.c_str());
    throw InputError(file + ": cannot be written");
  }
}

}  // namespace sfw
