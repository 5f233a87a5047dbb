#include "cli/bag_options.h"

#include <algorithm>
#include <vector>

#include "cli/warnings.h"
#include "files/text.h"
#include "ros/conversion/input_messages.h"
#include "ros/conversion/ros_settings.h"

namespace sfw {
namespace {

std::string listed(const std::vector<std::string>& words) {
  constexpr std::size_t kMost = 20;
  std::string text;
  for (std::size_t i = 0; i < std::min(words.size(), kMost); ++i) {
    text += (text.empty() ? "" : ", ") + words[i];
  }
  return words.empty() ? "none" : text + (words.size() > kMost ? ", ..." : "");
}

void replaceIfGiven(const std::string& given, std::string& frame) {
  frame = given.empty() ? frame : withoutSlash(given);
}

/// Warns of readings without position, and counts them.
void warnOfUnlocated(const BagReading& reading, const std::string& bags, const RosSettings& ros,
                     Mapper& mapper) {
  const std::size_t unlocated =
      reading.before_transforms + reading.after_transforms + reading.unlocated;
  if (unlocated > 0) {
    mapper.recordRejected("no transform at their stamp", unlocated);
  }
  const std::string frames = "from " + ros.antenna_frame + " to " + ros.map_frame;
  if (reading.before_transforms > 0) {
    warn(bags + ": " + std::to_string(reading.before_transforms) +
         " readings left out: the transforms " + frames + " begin " +
         formatted("%.1f", reading.transforms_from_s) +
         " s after the bag, and readings before have no position; start odometry and localisation "
         "before the recording");
  }
  if (reading.after_transforms > 0) {
    warn(bags + ": " + std::to_string(reading.after_transforms) +
         " readings left out: the transforms " + frames + " end " +
         formatted("%.1f", reading.transforms_until_s) +
         " s after the begin of the bag, and readings after have no position; look why odometry or "
         "localisation stopped");
  }
  if (reading.unlocated > 0) {
    const std::string remedy =
        reading.are_frames_connected
            ? "compare the clocks of the machines, since the bag has such transforms at other times"
            : "name the frames with --antenna-frame and --map-frame. Frames of the bag: " +
                  listed(reading.frames);
    warn(bags + ": " + std::to_string(reading.unlocated) +
         " readings left out: the bag has no transform " + frames + " at their stamp; " + remedy +
         ". tf's error: " + reading.tf_error);
  }
}

}  // namespace

void BagOptions::declare(Options& options) {
  options.addList("bag", "FILE", source.files,
                  "bag with /tf and scans; several for a recording that was split");
  for (const Input& input : kInputs) {
    options.add(input.bag_option, "TOPIC", topics[input.topic], input.meaning);
  }
  options.add("tf-topic", "TOPIC", source.tf_topic,
              "transforms in the bag; default: tf in the namespace of the scans, or else /tf");
  options.add("map-frame", "FRAME", map_frame, "for a bag; default: the setting ros/map_frame");
  options.add("antenna-frame", "FRAME", antenna_frame,
              "for a bag; default: the setting ros/antenna_frame");
  options.add("odom-frame", "FRAME", odom_frame,
              "for a bag; default: the setting ros/odom_frame, or else the frame of the odometry "
              "in tf");
}

RosSettings BagOptions::applied(RosSettings settings) const {
  replaceIfGiven(map_frame, settings.map_frame);
  replaceIfGiven(antenna_frame, settings.antenna_frame);
  replaceIfGiven(odom_frame, settings.odom_frame);
  return settings;
}

void insertBags(const BagOptions& options, const MappingSettings& settings, Mapper& mapper) {
  const BagReading reading = readBags(options.source, options.topics, settings, mapper);
  const std::string bags = namesOf(options.source.files);
  for (const auto& [problem, count] : reading.rejected) {
    mapper.recordRejected(problem, count);
    warn(bags + ": " + std::to_string(count) + " readings or contacts left out: " + problem);
  }
  const std::vector<std::string>& frames = reading.frames;
  if (reading.infinite_transforms > 0) {
    warn(bags + ": " + std::to_string(reading.infinite_transforms) +
         " transforms are infinite and not used; look for the node that publishes them");
  }
  warnOfUnlocated(reading, bags, settings.ros, mapper);
  if (!reading.odom_frame.empty() &&
      std::find(frames.begin(), frames.end(), reading.odom_frame) == frames.end()) {
    warn(bags + ": the bag has no frame " + reading.odom_frame +
         " (--odom-frame), so corrections by the localisation do not move the past. Frames of the "
         "bag: " +
         listed(frames));
  }
}

}  // namespace sfw
