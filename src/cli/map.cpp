#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

#include "belief/belief_model.h"
#include "cli/commands.h"
#include "cli/warnings.h"
#include "ros/bags/bag_reader.h"
#include "ros/conversion/input_messages.h"
#include "ros/conversion/ros_settings.h"
#include "structure_from_wifi/data_checks.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/map_files.h"
#include "structure_from_wifi/map_notes.h"
#include "structure_from_wifi/mapper.h"

namespace sfw {
namespace {

struct MapOptions {
  std::string readings;
  std::string bag;
  BagTopics topics = defaultBagTopics();
  std::string map_frame;
  std::string antenna_frame;
  std::string access_points;
  std::string contacts;
  std::string config;
  std::string output;
};

MappingSettings loadSettings(const MapOptions& options) {
  MappingSettings settings;
  if (!options.config.empty()) {
    settings = readMappingSettings(options.config);
  }
  for (const std::string& warning : settings.warnings) {
    warn(options.config + ": " + warning);
  }
  RosSettings& ros = settings.ros;
  ros.map_frame = options.map_frame.empty() ? ros.map_frame : options.map_frame;
  ros.antenna_frame = options.antenna_frame.empty() ? ros.antenna_frame : options.antenna_frame;
  return settings;
}

Mapper mapperFor(const std::string& access_points, const Config& config) {
  const std::vector<AccessPoint> table = accessPointsWithWarnings(access_points);
  configuredBeliefModel(config.belief);  // an error names its file, not the table
  try {
    return Mapper(config, table);
  } catch (const InputError& error) {
    throw InputError(access_points + ": " + error.what());
  }
}

void insertReadings(const MapOptions& options, Mapper& mapper) {
  const ReadingFile file = readWithWarnings(options.readings);
  for (const Reading& reading : file.readings) {
    mapper.insert(reading);
  }
  for (const auto& [reason, skipped] : file.skipped) {
    mapper.recordRejected(reason, skipped.count);
  }
}

void insertBag(const MapOptions& options, const MappingSettings& settings, Mapper& mapper) {
  const BagReading reading = readBag(options.bag, options.topics, settings, mapper);
  for (const auto& [problem, count] : reading.rejected) {
    mapper.recordRejected(problem, count);
    warn(options.bag + ": " + std::to_string(count) + " readings or contacts left out: " + problem);
  }
  if (reading.unlocated > 0) {
    mapper.recordRejected("no transform at their stamp", reading.unlocated);
    warn(options.bag + ": " + std::to_string(reading.unlocated) +
         " readings left out: the bag has no transform from " + settings.ros.antenna_frame +
         " to " + settings.ros.map_frame +
         " at their stamp; name the frames with --antenna-frame and " +
         "--map-frame. tf's error: " + reading.tf_error);
  }
}

void reportRejections(const std::string& source, const Rejections& rejections) {
  for (const auto& [insertion, count] : rejections.count) {
    warn(source + ": " + std::to_string(count) + " readings left out: " + toString(insertion));
  }
  constexpr std::size_t kMostListed = 20;
  std::size_t listed = 0;
  for (const auto& [bssid, count] : rejections.unknown_access_points) {
    if (listed++ == kMostListed) {
      warn("  ...");
      break;
    }
    warn("  " + bssid.str() + ": " + std::to_string(count) + " readings");
  }
}

/// Reports an access point whose position the table does not give.
void reportAccessPoint(const std::string& table, const AccessPointSummary& summary) {
  const std::string name = table + ": " + summary.access_point.bssid.str();
  if (!hasPosition(summary) && summary.readings > 0) {  // mapNotes reports those without readings
    warn(name + " is left out: it has no position, and its " + std::to_string(summary.readings) +
         " readings do not suffice to estimate one");
  } else if (summary.estimate) {
    const Position& position = summary.access_point.position;
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << name << " is estimated at (" << position.x()
         << ", " << position.y() << "), standard deviation "
         << std::sqrt(summary.estimate->covariance.diagonal().maxCoeff()) << " m";
    std::cerr << "sfw: " << text.str() << '\n';
  }
}

void run(const MapOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const MappingSettings settings = loadSettings(options);
  const Config& config = settings.config;
  Mapper mapper = mapperFor(options.access_points, config);
  const std::string& source = options.bag.empty() ? options.readings : options.bag;
  if (options.bag.empty()) {
    insertReadings(options, mapper);
  } else {
    insertBag(options, settings, mapper);
  }
  if (!options.contacts.empty()) {
    for (const Contact& contact : readContacts(options.contacts)) {
      mapper.insert(contact);
    }
  }
  reportRejections(source, mapper.rejections());
  const std::shared_ptr<const Snapshot> snapshot = mapper.infer();
  const auto& found = snapshot->access_points;
  if (std::all_of(found.begin(), found.end(), [](const auto& ap) { return ap.readings == 0; })) {
    throw InputError(source + ": no reading of an access point in " + options.access_points +
                     " can be used; the warnings above give the reasons");
  }
  const DataFindings findings = DataChecker().checkAll(*snapshot);
  for (const AccessPointSummary& summary : snapshot->access_points) {
    reportAccessPoint(options.access_points, summary);
  }
  for (const MapNote& note : mapNotes(*snapshot, findings)) {
    warn(source + ": " + note.text);
  }
  writeMapFiles(*snapshot, config, options.output, findings);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  std::cerr << "sfw: wrote the map to " << options.output << " in "
            << static_cast<int>(elapsed.count() * 1000) << " ms\n";
}

}  // namespace

void runMap(Options& options) {
  MapOptions map;
  options.add("readings", "FILE", map.readings,
              "CSV with the columns stamp, x, y, bssid, rssi_dbm; exactly one of --readings and "
              "--bag is needed");
  options.add("bag", "FILE", map.bag, "bag with /tf and scans");
  forEachInput([&](const auto& input) {
    using Message = typename std::decay_t<decltype(input)>::Message;
    const std::string type = ros::message_traits::DataType<Message>::value();
    if (input.bag_option != nullptr) {
      options.add(input.bag_option, "TOPIC", map.topics[input.topic],
                  type + " messages in the bag");
    }
  });
  options.add("map-frame", "FRAME", map.map_frame, "for a bag; default: the setting ros/map_frame");
  options.add("antenna-frame", "FRAME", map.antenna_frame,
              "for a bag; default: the setting ros/antenna_frame");
  options.addRequired("access-points", "FILE", map.access_points,
                      "YAML: access_points: [{bssid, x, y, z?, name?, tx_dbm?}]");
  options.add("contacts", "FILE", map.contacts,
              "CSV with the columns stamp, x, y: obstacles that the robot touched");
  options.add("config", "FILE", map.config, "settings as in config/mapping.yaml");
  options.addRequired("output", "DIRECTORY", map.output, "directory for the files of the map");
  if (!options.parse()) {
    return;
  }
  if (options.given("readings") == options.given("bag")) {
    throw InputError("map needs exactly one of --readings and --bag");
  }
  run(map);
}

}  // namespace sfw
