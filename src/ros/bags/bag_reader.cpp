#include "ros/bags/bag_reader.h"

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <vector>

#include "ros/conversion/input_messages.h"
#include "ros/mapping/insertion.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// Topic names are compared without a leading slash, because bags have them with and without it.
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

/// The input that has a topic in the bag, or nullptr.
const Input* inputOf(const std::string& topic, const BagTopics& topics) {
  const auto found = std::find_if(kInputs.begin(), kInputs.end(), [&](const Input& input) {
    const auto recorded = topics.find(input.topic);
    return recorded != topics.end() && plain(recorded->second) == plain(topic);
  });
  return found == kInputs.end() ? nullptr : &*found;
}

BagReading read(const std::string& file, const BagTopics& topics, const MappingSettings& settings,
                Mapper& mapper) {
  const rosbag::Bag bag(file, rosbag::bagmode::Read);
  rosbag::View view(bag);
  // No transform is too old, but stamp plus age must fit 32 bits of seconds.
  tf2::BufferCore transforms(ros::Duration(1e9));
  loadTransforms(bag, transforms);
  BagReading reading;
  PathCorrector corrector(jumpTolerance(settings.ros));
  InputContext context{{}, settings.ros.antenna_frame, settings.config.path.footprint_radius_m};
  for (const rosbag::MessageInstance& message : view) {
    const Input* input = inputOf(message.getTopic(), topics);
    if (input == nullptr) {
      continue;
    }
    context.received = message.getTime();
    const Conversion conversion = input->convert(toAnyMessage(message), context);
    if (!conversion.problem.empty() && input->is_radio) {
      reading.problems[message.getTopic()] = conversion.problem;
    }
    if (conversion.rejected > 0) {
      reading.rejected[conversion.problem] += conversion.rejected;
    }
    for (const Observation& observation : conversion.observations) {
      ++reading.observations;
      if (const auto located = locate(observation, settings.ros, transforms, reading.tf_error)) {
        insert(*located, mapper, corrector);
      } else {
        ++reading.unlocated;
      }
    }
  }
  if (const auto latest = latestCorrection(settings.ros, transforms)) {
    corrector.insert(*latest);
  }
  mapper.correct(corrector.correction());
  return reading;
}

[[noreturn]] void throwNoReading(const std::string& file, const BagTopics& topics,
                                 const BagReading& reading) {
  std::string names;
  std::string options;
  for (const Input& input : kInputs) {
    if (input.is_radio) {
      names += (names.empty() ? "" : " or ") + topics.at(input.topic);
      options += (options.empty() ? "--" : " and --") + std::string(input.bag_option);
    }
  }
  std::string problems;
  for (const auto& [topic, problem] : reading.problems) {
    problems += "; on " + topic + ", " + problem;
  }
  throw InputError(file + ": no reading on " + names + problems + "; name the topics with " +
                   options);
}

}  // namespace

BagTopics defaultBagTopics() {
  BagTopics topics;
  for (const Input& input : kInputs) {
    if (input.bag_option != nullptr) {
      topics[input.topic] = "/" + std::string(input.topic);
    }
  }
  return topics;
}

BagReading readBag(const std::string& file, const BagTopics& topics,
                   const MappingSettings& settings, Mapper& mapper) {
  BagReading reading;
  try {
    reading = read(file, topics, settings, mapper);
  } catch (const std::exception& error) {  // from rosbag, or from tf2 or a message that is broken
    throw InputError(file + ": cannot be read as a bag: " + error.what());
  }
  if (reading.observations == 0) {
    throwNoReading(file, topics, reading);
  }
  return reading;
}

}  // namespace sfw
