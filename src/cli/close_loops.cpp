#include <cstdint>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/far_positions.h"
#include "cli/recording_options.h"
#include "cli/rejections.h"
#include "files/text.h"
#include "localization/loop_closure.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/map_files.h"

namespace sfw {
namespace {

const char* wordFor(LoopClosure::Finding finding) {
  switch (finding) {
    case LoopClosure::Finding::kFewRadios:
      return "few radios";
    case LoopClosure::Finding::kNoLoop:
      return "no loop";
    case LoopClosure::Finding::kNoDrift:
      return "no drift";
    case LoopClosure::Finding::kContradicts:
      return "contradiction";
    case LoopClosure::Finding::kDrift:
      break;
  }
  return "drift";
}

std::string sentenceOn(const std::string& robot, const LoopClosure& loop) {
  const std::string whose = robot.empty() ? "" : " of " + robot;
  const std::string off =
      formatted("the path%s is off by %.1f m (median of %zu stretches of half a metre)",
                whose.c_str(), loop.before.distance_m, loop.closings);
  switch (loop.finding) {
    case LoopClosure::Finding::kFewRadios:
      return "the path" + whose + " stays: fewer than four radios sound alike at far places; add " +
             "access points to find drift";
    case LoopClosure::Finding::kNoLoop:
      return formatted(
          "the path%s stays: it returns to heard places in %zu stretches of half a "
          "metre only; drive a way twice to find drift",
          whose.c_str(), loop.closings);
    case LoopClosure::Finding::kNoDrift:
      return "where the robot returned, " + off + ", which is no more than the radio resolves; " +
             "it stays";
    case LoopClosure::Finding::kContradicts:
      return "where the robot seems to have returned, " + off +
             "; it stays, since no way of driving agrees with both signals and odometry; check "
             "that scans and odometry have one clock";
    case LoopClosure::Finding::kDrift:
      break;
  }
  return "where the robot returned, " + off +
         formatted("; corrected, it is off by %.1f m. Positions move by up to %.1f m",
                   loop.after.distance_m, loop.farthest_moved_m);
}

nlohmann::json toJson(const std::string& robot, const LoopClosure& loop) {
  const auto misfit = [](const LoopClosure::Misfit& one) {
    return nlohmann::json{{"distance_m", one.distance_m}, {"in_sigmas", one.in_sigmas}};
  };
  return {{"robot", robot},
          {"finding", wordFor(loop.finding)},
          {"closings", loop.closings},
          {"before", misfit(loop.before)},
          {"after", misfit(loop.after)},
          {"strain_per_m", loop.strain_per_m},
          {"farthest_moved_m", loop.farthest_moved_m}};
}

/// Writes the corrected recording, in its own frame.
void write(const LoadedRecording& recording, const std::string& directory) {
  const Mapper& mapper = recording.mapper;
  std::vector<Reading> readings = mapper.readings();
  std::vector<Contact> contacts = mapper.contacts();
  std::vector<AccessPoint> access_points = mapper.accessPoints();
  std::vector<PathPose> path = mapper.poses();
  const Position back = -recording.offset;
  subtract(back, readings);
  subtract(back, access_points);
  for (Contact& contact : contacts) {
    contact.point_in_map = near(contact.point_in_map, back);
  }
  for (PathPose& pose : path) {
    pose.antenna_in_map = near(pose.antenna_in_map, back);
  }
  writeRecording(readings, contacts, access_points, directory, path);
}

std::map<std::string, LoopClosure> loopsOf(const LoadedRecording& recording, std::int64_t seed) {
  try {
    return closeLoopsByRobot(recording.mapper.readings(), seed);
  } catch (const InputError& error) {
    throw InputError(recording.source + ": " + error.what());
  }
}

}  // namespace

void runCloseLoops(Options& options) {
  RecordingOptions recording_options;
  std::string output;
  std::int64_t seed = 0;
  bool json = false;
  recording_options.declare(options);
  options.add("seed", "N", seed, "seed of the particle filter");
  options.addFlag("json", json, "print what was found as JSON");
  options.addRequired("output", "DIRECTORY", output,
                      "directory for the corrected recording: readings.csv, contacts.csv, path.csv "
                      "and access_points.yaml");
  if (!options.parse()) {
    return;
  }
  recording_options.check();
  LoadedRecording recording = loadRecording(recording_options);
  reportRejections(recording.source, recording.mapper.rejections(), {},
                   !recording.mapper.readings().empty());
  if (recording.mapper.readings().empty()) {
    throw InputError(recording.source +
                     ": no reading can be used; the warnings above give the reasons");
  }
  const std::map<std::string, LoopClosure> loops = loopsOf(recording, seed);
  nlohmann::json found = nlohmann::json::array();
  for (const auto& [robot, loop] : loops) {
    std::cerr << "sfw: " << recording.source << ": " << sentenceOn(robot, loop) << '\n';
    found.push_back(toJson(robot, loop));
  }
  recording.mapper.correct([&](std::int64_t stamp_ns, const Position& point,
                               const std::string& robot) {
    const auto own = loops.find(robot);
    const bool drifted = own != loops.end() && own->second.finding == LoopClosure::Finding::kDrift;
    return drifted ? own->second.moved(stamp_ns, point) : point;
  });
  if (json) {
    std::cout << found.dump(2) << '\n';
  }
  write(recording, output);
}

}  // namespace sfw
