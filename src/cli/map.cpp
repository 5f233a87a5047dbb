#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>

#include "belief/belief_model.h"
#include "checks/recording_checks.h"
#include "checks/recording_notes.h"
#include "cli/bag_options.h"
#include "cli/commands.h"
#include "cli/far_positions.h"
#include "cli/warnings.h"
#include "mapping/inliers.h"
#include "output/moved.h"
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
  BagOptions bags;
  std::string access_points;
  std::string contacts;
  std::string path;
  double scale = 1.0;
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
  settings.ros = options.bags.applied(settings.ros);
  return settings;
}

std::vector<AccessPoint> tableOf(const MapOptions& options) {
  std::vector<AccessPoint> table = accessPointsWithWarnings(options.access_points);
  for (AccessPoint& access_point : table) {
    access_point.position *= options.scale;
  }
  return table;
}

/// Reads the file of readings, in metres.
ReadingFile readingsOf(const MapOptions& options) {
  ReadingFile file = options.bags.source.files.empty()
                         ? readWithWarnings(options.readings, options.path)
                         : ReadingFile{};
  for (Reading& reading : file.readings) {
    reading.antenna_in_map *= options.scale;
  }
  return file;
}

/// A note on units that make the map useless and slow, before it is made.
std::optional<std::string> noteOnUnits(const std::vector<Reading>& readings,
                                       const std::vector<AccessPoint>& table,
                                       const Config& config) {
  const RecordingData data{sortedByStamp(readings), {}, 0};
  RecordingFindings units;
  units.units = checkRecording({data, table, {}, 0, config.path.max_gap_m}).units;
  std::vector<MapNote> notes;
  addNotesOnRecording(units, notes);
  return notes.empty() ? std::nullopt : std::optional(notes.front().text);
}

Mapper mapperFor(const MapOptions& options, const std::vector<Reading>& readings,
                 const Position& offset, const Config& config) {
  std::vector<AccessPoint> table = tableOf(options);
  subtract(offset, table);
  requireSameFrame(offset, table, options.access_points);
  configuredBeliefModel(config.belief);  // an error names its file, not the table
  const std::optional<std::string> units = noteOnUnits(readings, table, config);
  try {
    Mapper mapper(config, table);
    if (units) {
      std::cerr << "sfw: " << options.readings << ": " << units->substr(0, units->find(';'))
                << "; making the map may take minutes\n";
    }
    return mapper;
  } catch (const InputError& error) {
    throw InputError(units ? options.readings + ": " + *units
                           : options.access_points + ": " + error.what());
  }
}

void insertReadings(const ReadingFile& file, Mapper& mapper) {
  for (const Reading& reading : file.readings) {
    mapper.insert(reading);
  }
  for (const auto& [reason, skipped] : file.skipped) {
    mapper.recordRejected(reason, skipped.count);
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

/// Reports the estimated positions of the first few access points; report.json has all of them.
void reportEstimates(const std::string& table, const std::vector<AccessPointSummary>& summaries) {
  constexpr std::size_t kMostListed = 5;
  std::size_t estimated = 0;
  for (const AccessPointSummary& summary : summaries) {
    if (!summary.estimate || ++estimated > kMostListed) {
      continue;
    }
    const Position& position = summary.access_point.position;
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << table << ": " << summary.access_point.bssid.str()
         << " is estimated at (" << position.x() << ", " << position.y() << "), standard deviation "
         << std::sqrt(summary.estimate->covariance.diagonal().maxCoeff()) << " m";
    std::cerr << "sfw: " << text.str() << '\n';
  }
  if (estimated > kMostListed) {
    std::cerr << "sfw: " << table << ": " << estimated - kMostListed
              << " more positions are estimated; report.json lists them\n";
  }
}

void run(const MapOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const MappingSettings settings = loadSettings(options);
  const Config& config = settings.config;
  ReadingFile file = readingsOf(options);
  const Position offset = offsetOf(file.readings);
  subtract(offset, file.readings);
  Mapper mapper = mapperFor(options, file.readings, offset, config);
  const bool is_bag = !options.bags.source.files.empty();
  const std::string source = is_bag ? namesOf(options.bags.source.files) : options.readings;
  if (is_bag) {
    insertBags(options.bags, settings, mapper);
  } else {
    insertReadings(file, mapper);
  }
  if (!options.contacts.empty()) {
    for (Contact contact : readContacts(options.contacts)) {
      contact.point_in_map = near(contact.point_in_map * options.scale, offset);
      mapper.insert(contact);
    }
  }
  if (!options.path.empty()) {
    for (const PathPose& pose : readPath(options.path)) {
      mapper.insertPose(pose.stamp_ns, near(pose.antenna_in_map * options.scale, offset));
    }
  }
  reportRejections(source, mapper.rejections());
  const std::shared_ptr<const Snapshot> made = mapper.infer();
  const DataFindings findings = moved(DataChecker().checkAll(*made), offset);
  const Snapshot snapshot = moved(*made, offset);
  const auto& found = snapshot.access_points;
  reportEstimates(options.access_points, found);
  for (const MapNote& note : mapNotes(snapshot, findings)) {
    warn(source + ": " + note.text);
  }
  if (std::all_of(found.begin(), found.end(), [](const auto& ap) { return ap.readings == 0; })) {
    throw InputError(source + ": no reading of an access point in " + options.access_points +
                     " can be used; the warnings above give the reasons");
  }
  writeMapFiles(snapshot, config, options.output, findings);
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
  map.bags.declare(options);
  options.addRequired("access-points", "FILE", map.access_points,
                      "YAML: access_points: [{bssid, x, y, z?, name?, tx_dbm?}]");
  options.add("contacts", "FILE", map.contacts,
              "CSV with the columns stamp, x, y: obstacles that the robot touched");
  options.add("path", "FILE", map.path,
              "CSV with the columns stamp, x, y: the way driven. It fills gaps between readings, "
              "and places readings without x and y, such as those of WiGLE and Kismet");
  options.add(
      "scale", "METRES", map.scale,
      "length of the unit of x and y in the files of readings, contacts, path and access points: "
      "0.01 for centimetres");
  options.add("config", "FILE", map.config, "settings as in config/mapping.yaml");
  options.addRequired("output", "DIRECTORY", map.output, "directory for the files of the map");
  if (!options.parse()) {
    return;
  }
  if (options.given("readings") == options.given("bag")) {
    throw InputError("map needs exactly one of --readings and --bag");
  }
  if (options.given("path") && options.given("bag")) {
    throw InputError("--path goes with --readings: a bag has the path in /tf");
  }
  if (!(map.scale > 0.0) || !std::isfinite(map.scale)) {
    throw InputError("--scale must be a number above 0");
  }
  if (options.given("scale") && options.given("bag")) {
    throw InputError("--scale goes with --readings: positions of a bag are in metres");
  }
  run(map);
}

}  // namespace sfw
