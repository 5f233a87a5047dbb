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
#include "ros/mapping/floors.h"
#include "ros/mapping/insertion.h"
#include "ros/mapping/odometry_frame.h"
#include "ros/mapping/path_sampler.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// The input that has a topic in the bag, or nullptr.
const Input* inputOf(const std::string& topic, const BagTopics& topics) {
  const auto found = std::find_if(kInputs.begin(), kInputs.end(), [&](const Input& input) {
    const auto recorded = topics.find(input.topic);
    return recorded != topics.end() && plainTopic(recorded->second) == plainTopic(topic);
  });
  return found == kInputs.end() ? nullptr : &*found;
}

/// The topics in bags that may bring readings.
std::vector<std::string> radioTopics(const std::vector<std::string>& recorded,
                                     const BagTopics& topics) {
  std::vector<std::string> found;
  for (const Input& input : kInputs) {
    const auto named = topics.find(input.topic);
    const std::string topic = named == topics.end() ? "" : plainTopic(named->second);
    if (input.is_radio && std::find(recorded.begin(), recorded.end(), topic) != recorded.end()) {
      found.push_back(topic);
    }
  }
  return found;
}

/// Inserts the observations of messages into a mapper.
class Insertion {
 public:
  /// @param span  of the transforms from antenna to map
  Insertion(const MappingSettings& settings, const tf2::BufferCore& transforms,
            const std::optional<TransformSpan>& span, Mapper& mapper)
      : ros_(settings.ros),
        transforms_(transforms),
        span_(span),
        mapper_(mapper),
        corrector_(jumpTolerance(settings.ros)),
        sampler_(settings.ros) {}

  void insert(const Conversion& conversion, BagReading& reading) {
    if (conversion.rejected > 0) {
      reading.rejected[conversion.problem] += conversion.rejected;
    }
    for (const Observation& observation : conversion.observations) {
      ++reading.observations;
      std::string tf_error;
      auto located = locate(observation, ros_, transforms_, tf_error);
      if (!located) {
        countUnlocated(observation.stamp, tf_error, reading);
        continue;
      }
      if (!located->readings.empty()) {
        floors_.observe(located->sensor_height_m);
        located->way = sampler_.extendTo(located->readings.front().stamp_ns, transforms_);
      }
      sfw::insert(*located, mapper_, corrector_);
    }
  }

  /// Corrects the path by all that came, and tells what is wrong with transforms.
  void finish(FrameFinding frames) {
    frames.floors_m = floors_.heights();
    mapper_.recordFrames(frames);
    if (const auto latest = latestCorrection(ros_, transforms_)) {
      corrector_.insert(*latest);
    }
    mapper_.correct(corrector_.correction());
  }

 private:
  void countUnlocated(const ros::Time& stamp, const std::string& tf_error,
                      BagReading& reading) const {
    if (span_ && stamp < span_->first_stamp) {
      ++reading.before_transforms;
    } else if (span_ && stamp > span_->last_stamp) {
      ++reading.after_transforms;
    } else {
      ++reading.unlocated;
      reading.tf_error = tf_error;
    }
  }

  const RosSettings& ros_;
  const tf2::BufferCore& transforms_;
  const std::optional<TransformSpan> span_;
  Mapper& mapper_;
  PathCorrector corrector_;
  PathSampler sampler_;
  Floors floors_;
};

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
  reading.odom_frame = odometryFrame(settings.ros, transforms);
  reading.infinite_transforms = loaded.infinite;
  const std::vector<std::string> way =
      framesBetween(settings.ros.map_frame, settings.ros.antenna_frame, transforms);
  reading.are_frames_connected = !way.empty();
  const std::optional<TransformSpan> span = loaded.times.spanOf(way);
  if (span) {
    reading.transforms_from_s = span->first_received.toSec() - view.getBeginTime().toSec();
    reading.transforms_until_s = span->last_received.toSec() - view.getBeginTime().toSec();
  }
  Insertion insertion(settings, transforms, span, mapper);
  InputContext context{{},
                       settings.ros.antenna_frame,
                       settings.config.path.footprint_radius_m,
                       toScanFormat(settings.scan)};
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
    insertion.insert(conversion, reading);
  }
  insertion.finish(watch.finding(settings.ros.antenna_frame));
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
    topics[input.topic] = "/" + std::string(input.topic);
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
