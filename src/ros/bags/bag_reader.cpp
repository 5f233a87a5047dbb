#include "ros/bags/bag_reader.h"

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2/buffer_core.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "ros/bags/bag_files.h"
#include "ros/bags/bag_transforms.h"
#include "ros/conversion/input_messages.h"
#include "ros/conversion/robot_topics.h"
#include "ros/mapping/floors.h"
#include "ros/mapping/insertion.h"
#include "ros/mapping/odometry_frame.h"
#include "ros/mapping/robots.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// The input that has a topic in the bag, or nullptr.
/// @param topic  without a leading slash
const Input* inputOf(const std::string& topic, const BagTopics& topics) {
  const auto found = std::find_if(kInputs.begin(), kInputs.end(), [&](const Input& input) {
    const auto recorded = topics.find(input.topic);
    return recorded != topics.end() &&
           std::any_of(recorded->second.begin(), recorded->second.end(),
                       [&](const std::string& name) { return plainTopic(name) == topic; });
  });
  return found == kInputs.end() ? nullptr : &*found;
}

/// The topics in bags that may bring readings.
std::vector<std::string> radioTopics(const std::vector<std::string>& recorded,
                                     const BagTopics& topics) {
  std::vector<std::string> found;
  for (const Input& input : kInputs) {
    const auto named = topics.find(input.topic);
    if (!input.is_radio || named == topics.end()) {
      continue;
    }
    for (const std::string& name : named->second) {
      if (std::find(recorded.begin(), recorded.end(), plainTopic(name)) != recorded.end()) {
        found.push_back(plainTopic(name));
      }
    }
  }
  return found;
}

/// Inserts the observations of messages into a mapper.
class Insertion {
 public:
  /// @param spans  of each robot's transforms from antenna to map
  Insertion(const MappingSettings& settings, const tf2::BufferCore& transforms,
            const std::vector<std::optional<TransformSpan>>& spans, Mapper& mapper)
      : transforms_(transforms),
        spans_(spans),
        mapper_(mapper),
        corrector_(jumpTolerance(settings.ros)),
        robots_(settings.ros) {}

  void insert(const Conversion& conversion, BagReading& reading) {
    for (const auto& [reason, count] : conversion.rejected) {
      reading.rejected[reason] += count;
    }
    for (const Observation& observation : conversion.observations) {
      ++reading.observations;
      std::string tf_error;
      auto located = robots_.locate(observation, transforms_, tf_error);
      if (!located) {
        countUnlocated(observation, tf_error, reading);
        continue;
      }
      if (!located->readings.empty()) {
        floors_.observe(located->sensor_height_m);
      }
      robots_.sampleWay(transforms_, *located);
      sfw::insert(*located, mapper_, corrector_);
    }
  }

  /// Corrects the path by all that came, and tells what is wrong with transforms.
  void finish(FrameFinding frames) {
    frames.floors_m = floors_.heights();
    mapper_.recordFrames(frames);
    for (const OdometryCorrection& latest : robots_.latestCorrections(transforms_)) {
      corrector_.insert(latest);
    }
    mapper_.correct(corrector_.correction());
  }

 private:
  void countUnlocated(const Observation& observation, const std::string& tf_error,
                      BagReading& reading) const {
    const std::size_t robot = robots_.robotOf(observation, transforms_);
    const std::optional<TransformSpan>& span = spans_[robot];
    UnlocatedCount& count = reading.unlocated[robot];
    if (span && observation.stamp < span->first_stamp) {
      ++count.before_transforms;
    } else if (span && observation.stamp > span->last_stamp) {
      ++count.after_transforms;
    } else {
      ++count.others;
      count.tf_error = tf_error;
    }
  }

  const tf2::BufferCore& transforms_;
  const std::vector<std::optional<TransformSpan>> spans_;
  Mapper& mapper_;
  PathCorrector corrector_;
  Robots robots_;
  Floors floors_;
};

/// The count of a robot before any observation.
UnlocatedCount countFor(const RosSettings& robot, const std::optional<TransformSpan>& span,
                        const ros::Time& begin, bool are_frames_connected) {
  UnlocatedCount count;
  count.antenna_frame = robot.antenna_frame;
  count.are_frames_connected = are_frames_connected;
  if (span) {  // in double, since a ros::Duration cannot hold any difference
    count.transforms_from_s = span->first_received.toSec() - begin.toSec();
    count.transforms_until_s = span->last_received.toSec() - begin.toSec();
  }
  return count;
}

BagReading read(const BagFiles& bags, const std::string& tf_topic, const BagTopics& topics,
                const MappingSettings& settings, Mapper& mapper) {
  // No transform is too old, but stamp plus age must fit 32 bits of seconds.
  tf2::BufferCore transforms(ros::Duration(1e9));
  TransformWatch watch;
  LoadedTransforms loaded;
  if (!tf_topic.empty()) {
    loaded = loadTransforms(bags, tf_topic, transforms, watch);
  }
  rosbag::View view;
  for (const auto& bag : bags.bags()) {
    view.addQuery(*bag);
  }
  BagReading reading;
  transforms._getFrameStrings(reading.frames);
  reading.infinite_transforms = loaded.infinite;
  const Robots robots(settings.ros);
  reading.odom_frame = odometryFrame(robots.settings().front(), transforms);
  std::vector<std::optional<TransformSpan>> spans;
  for (const RosSettings& robot : robots.settings()) {
    const std::vector<std::string> way =
        framesBetween(robot.map_frame, robot.antenna_frame, transforms);
    spans.push_back(loaded.times.spanOf(way));
    reading.unlocated.push_back(countFor(robot, spans.back(), view.getBeginTime(), !way.empty()));
  }
  Insertion insertion(settings, transforms, spans, mapper);
  InputContext context{{},
                       "",
                       settings.config.path.footprint_radius_m,
                       toScanFormat(settings.scan),
                       antennaFrames(settings.ros)};
  for (const rosbag::MessageInstance& message : view) {
    const Input* input = inputOf(plainTopic(message.getTopic()), topics);
    if (input == nullptr) {
      continue;
    }
    context.received = message.getTime();
    context.antenna_frame = robotOfTopic(message.getTopic(), context.antenna_frames);
    const Conversion conversion = input->convert(toAnyMessage(message), context);
    if (!conversion.problem.empty() && input->is_radio) {
      reading.problems[message.getTopic()] = conversion.problem;
    }
    insertion.insert(conversion, reading);
  }
  FrameFinding frames;
  for (const RosSettings& robot : robots.settings()) {
    frames = frames.published_twice.empty() ? watch.finding(robot.antenna_frame) : frames;
  }
  insertion.finish(frames);
  return reading;
}

[[noreturn]] void throwNoReading(const std::string& file, const BagTopics& topics,
                                 const BagReading& reading) {
  std::string names;
  std::string options;
  for (const Input& input : kInputs) {
    if (input.is_radio) {
      for (const std::string& topic : topics.at(input.topic)) {
        names += (names.empty() ? "" : " or ") + topic;
      }
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
    topics[input.topic] = {"/" + std::string(input.topic)};
  }
  return topics;
}

std::string namesOf(const std::vector<std::string>& files) {
  const std::size_t others = files.size() - 1;
  return files.front() + (others == 0   ? ""
                          : others == 1 ? " and another bag"
                                        : " and " + std::to_string(others) + " more bags");
}

BagReading readBags(const BagSource& source, const BagTopics& topics,
                    const MappingSettings& settings, Mapper& mapper) {
  const std::string names = namesOf(source.files);
  const BagFiles bags(source.files);
  BagReading reading;
  std::string tf_topic, tf_problem;
  try {
    const std::vector<std::string> recorded = bags.topics();
    try {
      tf_topic = findTransformTopic(recorded, radioTopics(recorded, topics), source.tf_topic);
    } catch (const InputError& error) {
      tf_problem = error.what();
    }
    reading = read(bags, tf_topic, topics, settings, mapper);
  } catch (const std::exception& error) {  // from rosbag, or from tf2 or a message that is broken
    throw InputError(names + ": cannot be read as a bag: " + error.what());
  }
  if (reading.observations == 0) {
    throwNoReading(names, topics, reading);
  }
  if (!tf_problem.empty()) {
    throw InputError(names + ": " + tf_problem);
  }
  return reading;
}

}  // namespace sfw
