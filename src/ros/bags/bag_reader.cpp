#include "ros/bags/bag_reader.h"

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>

#include "ros/mapping/observation_queue.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// Topic names compare without a leading slash: bags have them with and without.
std::string plain(const std::string& topic) {
  return !topic.empty() && topic.front() == '/' ? topic.substr(1) : topic;
}

void loadTransforms(const rosbag::Bag& bag, tf2::BufferCore& transforms) {
  const auto load = [&](const char* topic, bool is_static) {
    rosbag::View view(bag, rosbag::TopicQuery(std::vector<std::string>{topic, plain(topic)}));
    for (const rosbag::MessageInstance& message : view) {
      if (const auto tf = message.instantiate<tf2_msgs::TFMessage>()) {
        for (const geometry_msgs::TransformStamped& transform : tf->transforms) {
          transforms.setTransform(transform, "bag", is_static);
        }
      }
    }
  };
  load("/tf", false);
  load("/tf_static", true);
}

std::vector<Observation> observationsOf(const rosbag::MessageInstance& message,
                                        const BagTopics& topics, std::size_t& malformed) {
  const std::string topic = plain(message.getTopic());
  const ros::Time& received = message.getTime();
  if (topic == plain(topics.wifi_scan)) {
    if (const auto scan = message.instantiate<structure_from_wifi::WifiScan>()) {
      return toObservations(*scan, received, malformed);
    }
  } else if (topic == plain(topics.connection)) {
    if (const auto connection = message.instantiate<wireless_msgs::Connection>()) {
      return toObservations(*connection, received);
    }
  } else if (topic == plain(topics.contact_points)) {
    if (const auto cloud = message.instantiate<sensor_msgs::PointCloud2>()) {
      try {
        return {toObservation(*cloud, received)};
      } catch (const std::runtime_error&) {
        ++malformed;
      }
    }
  }
  return {};
}

BagReading read(const std::string& file, const BagTopics& topics, const Config::Ros& config,
                Mapper& mapper) {
  const rosbag::Bag bag(file, rosbag::bagmode::Read);
  rosbag::View view(bag);
  // Nothing is too old to be kept, but stamp plus age must fit 32 bits of seconds.
  tf2::BufferCore transforms(ros::Duration(1e9));
  loadTransforms(bag, transforms);
  BagReading reading;
  PathCorrector anchor(jumpTolerance(config));
  for (const rosbag::MessageInstance& message : view) {
    for (const Observation& observation : observationsOf(message, topics, reading.malformed)) {
      ++reading.observations;
      if (const auto placed = place(observation, config, transforms, reading.reason)) {
        insert(*placed, mapper, anchor);
      } else {
        ++reading.unplaced;
      }
    }
  }
  if (const std::optional<OdometryCorrection> latest = latestFix(config, transforms)) {
    anchor.insert(*latest);
  }
  mapper.correct(anchor.correction());
  return reading;
}

}  // namespace

BagReading readBag(const std::string& file, const BagTopics& topics, const Config::Ros& config,
                   Mapper& mapper) {
  BagReading reading;
  try {
    reading = read(file, topics, config, mapper);
  } catch (const std::exception& error) {  // from rosbag, or from tf2 or a message that is broken
    throw InputError(file + ": cannot be read as a bag: " + error.what());
  }
  if (reading.observations == 0) {
    throw InputError(file + ": no reading on " + topics.wifi_scan + " or " + topics.connection +
                     "; name the topics with --scan-topic and --connection-topic");
  }
  return reading;
}

}  // namespace sfw
