#include "cli/bag_options.h"

#include <algorithm>
#include <vector>

#include "base/validation.h"
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

/// Warns of a robot's readings without position.
void warnOfUnlocated(const UnlocatedCount& count, const std::string& bags,
                     const std::string& map_frame, const std::vector<std::string>& all_frames) {
  const std::string frames = "from " + count.antenna_frame + " to " + map_frame;
  if (count.before_transforms > 0) {
    warn(bags + ": " + std::to_string(count.before_transforms) +
         " readings left out: the transforms " + frames + " begin " +
         formatted("%.1f", count.transforms_from_s) +
         " s after the bag, and readings before have no position; start odometry and localisation "
         "before the recording");
  }
  if (count.after_transforms > 0) {
    warn(bags + ": " + std::to_string(count.after_transforms) +
         " readings left out: the transforms " + frames + " end " +
         formatted("%.1f", count.transforms_until_s) +
         " s after the begin of the bag, and readings after have no position; look why odometry or "
         "localisation stopped");
  }
  if (count.others > 0) {
    const std::string remedy =
        count.are_frames_connected
            ? "compare the clocks of the machines, since the bag has such transforms at other times"
            : "name the frames with --antenna-frame and --map-frame. Frames of the bag: " +
                  listed(all_frames);
    warn(bags + ": " + std::to_string(count.others) +
         " readings left out: the bag has no transform " + frames + " at their stamp; " + remedy +
         ". tf's error: " + count.tf_error);
  }
}

}  // namespace

void BagOptions::declare(Options& options) {
  options.addList("bag", "FILE", source.files,
                  "bag with /tf and scans; several for a recording that was split");
  for (const Input& input : kInputs) {
    std::vector<std::string>& names = topics[input.topic];
    options.addList(input.bag_option, "TOPIC", names,
                    std::string(input.meaning) + "; default: " + names.front());
  }
  options.add("tf-topic", "TOPIC", source.tf_topic,
              "transforms in the bag; default: tf in the namespace of the scans, or else /tf");
  options.add("map-frame", "FRAME", map_frame, "for a bag; default: the setting ros/map_frame");
  options.addList("antenna-frame", "FRAME", antenna_frames,
                  "for a bag; of several robots, each scan's frame_id names one; default: the "
                  "settings ros/antenna_frames or ros/antenna_frame");
  options.add("odom-frame", "FRAME", odom_frame,
              "for a bag; default: the setting ros/odom_frame, or else the frame of the odometry "
              "in tf");
}

RosSettings BagOptions::applied(RosSettings settings) const {
  replaceIfGiven(map_frame, settings.map_frame);
  if (!antenna_frames.empty()) {
    settings.antenna_frames.clear();
    for (const std::string& frame : antenna_frames) {
      settings.antenna_frames += frame + " ";
    }
  }
  replaceIfGiven(odom_frame, settings.odom_frame);
  return settings;
}

void insertBags(const BagOptions& options, const MappingSettings& settings, Mapper& mapper) {
  throwIfAny(validate(settings.ros));  // options may contradict one another
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
  for (const UnlocatedCount& count : reading.unlocated) {
    const std::size_t all = count.before_transforms + count.after_transforms + count.others;
    if (all > 0) {
      mapper.recordRejected("no transform at their stamp", all);
      warnOfUnlocated(count, bags, settings.ros.map_frame, frames);
    }
  }
  if (!reading.odom_frame.empty() &&
      std::find(frames.begin(), frames.end(), reading.odom_frame) == frames.end()) {
    warn(bags + ": the bag has no frame " + reading.odom_frame +
         " (--odom-frame), so corrections by the localisation do not move the past. Frames of the "
         "bag: " +
         listed(frames));
  }
}

}  // namespace sfw
