#include "ros/mapping/robots.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <limits>
#include <variant>

#include "ros/mapping/odometry_frame.h"

namespace sfw {

Robots::Robots(const RosSettings& settings) {
  for (const std::string& frame : antennaFrames(settings)) {
    settings_.push_back(settings);
    settings_.back().antenna_frame = frame;
    settings_.back().antenna_frames.clear();
    samplers_.emplace_back(settings_.back());
  }
}

/// The name in readings. One robot alone has none, so that its files have no column for it.
std::string Robots::nameOf(std::size_t robot) const {
  return settings_.size() == 1 ? "" : settings_[robot].antenna_frame;
}

std::size_t Robots::robotOf(const Observation& observation,
                            const tf2::BufferCore& transforms) const {
  std::size_t nearest = 0;
  if (settings_.size() == 1) {
    return nearest;
  }
  const auto* contacts = std::get_if<UnlocatedContacts>(&observation.content);
  std::size_t shortest = std::numeric_limits<std::size_t>::max();
  for (std::size_t i = 0; i < settings_.size(); ++i) {
    const std::string& antenna = settings_[i].antenna_frame;
    if (contacts == nullptr) {
      nearest = observation.robot == antenna ? i : nearest;
      continue;
    }
    const std::size_t way = framesBetween(antenna, contacts->frame, transforms).size();
    if (way > 0 && way < shortest) {
      shortest = way;
      nearest = i;
    }
  }
  return nearest;
}

std::optional<LocatedObservation> Robots::locate(const Observation& observation,
                                                 const tf2::BufferCore& transforms,
                                                 std::string& tf_error) const {
  try {
    const std::size_t robot = robotOf(observation, transforms);
    std::optional<LocatedObservation> located =
        sfw::locate(observation, settings_[robot], transforms, tf_error);
    if (located && settings_.size() > 1) {
      const std::string name = nameOf(robot);
      for (Reading& reading : located->readings) {
        reading.robot = name;
      }
      for (Contact& contact : located->contacts) {
        contact.robot = name;
      }
      if (located->correction) {
        located->correction->robot = name;
      }
    }
    return located;
  } catch (const std::exception& error) {  // the buffer changed between two look-ups
    tf_error = error.what();
    return std::nullopt;
  }
}

void Robots::sampleWay(const tf2::BufferCore& transforms, LocatedObservation& observation) {
  if (observation.readings.empty()) {
    return;
  }
  const Reading& reading = observation.readings.front();
  for (std::size_t i = 0; i < settings_.size(); ++i) {
    if (nameOf(i) != reading.robot) {
      continue;
    }
    observation.way = samplers_[i].extendTo(reading.stamp_ns, transforms);
    for (LocatedPose& sample : observation.way) {
      sample.pose.robot = reading.robot;
      if (sample.correction) {
        sample.correction->robot = reading.robot;
      }
    }
  }
}

void Robots::forgetWays() {
  for (PathSampler& sampler : samplers_) {
    sampler.clear();
  }
}

std::vector<OdometryCorrection> Robots::latestCorrections(const tf2::BufferCore& transforms) const {
  std::vector<OdometryCorrection> corrections;
  for (std::size_t i = 0; i < settings_.size(); ++i) {
    if (auto correction = latestCorrection(settings_[i], transforms)) {
      correction->robot = nameOf(i);
      corrections.push_back(*correction);
    }
  }
  return corrections;
}

std::string antennaFramesText(const RosSettings& settings) {
  std::string text;
  for (const std::string& frame : antennaFrames(settings)) {
    text += (text.empty() ? "" : " or ") + frame;
  }
  return text;
}

}  // namespace sfw
