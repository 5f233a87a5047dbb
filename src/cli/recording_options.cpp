#include "cli/recording_options.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>
#include <utility>
#include <vector>

#include "belief/belief_model.h"
#include "checks/recording_checks.h"
#include "checks/recording_notes.h"
#include "cli/far_positions.h"
#include "cli/warnings.h"
#include "mapping/inliers.h"
#include "ros/conversion/ros_settings.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

MappingSettings loadSettings(const RecordingOptions& options) {
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

std::vector<AccessPoint> tableOf(const RecordingOptions& options) {
  std::vector<AccessPoint> table;
  if (!options.access_points.empty()) {
    table = accessPointsWithWarnings(options.access_points);
  }
  for (AccessPoint& access_point : table) {
    access_point.position *= options.scale;
    if (access_point.position_sd_m) {
      *access_point.position_sd_m *= options.scale;
    }
  }
  return table;
}

/// Reads the file of readings, in metres.
ReadingFile readingsOf(const RecordingOptions& options) {
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
  units.units = checkUnits({data, table, {}, 0, config.path.max_gap_m});
  std::vector<MapNote> notes;
  addNotesOnRecording(units, notes);
  return notes.empty() ? std::nullopt : std::optional(notes.front().text);
}

Mapper mapperFor(const RecordingOptions& options, const std::vector<Reading>& readings,
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
    const std::string& table_file = options.access_points;
    throw InputError(units ? options.readings + ": " + *units
                           : (table_file.empty() ? "" : table_file + ": ") + error.what());
  }
}

void insertReadings(const ReadingFile& file, Mapper& mapper) {
  mapper.reserve(file.readings.size());
  for (const Reading& reading : file.readings) {
    mapper.insert(reading);
  }
  for (const auto& [reason, skipped] : file.skipped) {
    mapper.recordRejected(reason, skipped.count);
  }
}

}  // namespace

void RecordingOptions::declare(Options& options) {
  options.add("readings", "FILE", readings,
              "CSV with the columns stamp, x, y, bssid, rssi_dbm; exactly one of --readings and "
              "--bag is needed");
  bags.declare(options);
  options.add("access-points", "FILE", access_points,
              "YAML: access_points: [{bssid, x?, y?, z?, name?, tx_dbm?}]; default: all that are "
              "heard, at estimated positions");
  options.add("contacts", "FILE", contacts,
              "CSV with the columns stamp, x, y: obstacles that the robot touched");
  options.add("path", "FILE", path,
              "CSV with the columns stamp, x, y: the way driven. It fills gaps between readings, "
              "and places readings without x and y, such as those of WiGLE and Kismet");
  options.add(
      "scale", "METRES", scale,
      "length of the unit of x and y in the files of readings, contacts, path and access points: "
      "0.01 for centimetres");
  options.add("config", "FILE", config, "settings as in config/mapping.yaml");
}

void RecordingOptions::check() const {
  const bool has_bag = !bags.source.files.empty();
  if (readings.empty() != has_bag) {
    throw InputError("exactly one of --readings and --bag is needed");
  }
  if (!path.empty() && has_bag) {
    throw InputError("--path goes with --readings: a bag has the path in /tf");
  }
  if (!(scale > 0.0) || !std::isfinite(scale)) {
    throw InputError("--scale must be a number above 0");
  }
  if (scale != 1.0 && has_bag) {
    throw InputError("--scale goes with --readings: positions of a bag are in metres");
  }
}

LoadedRecording loadRecording(const RecordingOptions& options) {
  const MappingSettings settings = loadSettings(options);
  ReadingFile file = readingsOf(options);
  const Position offset = offsetOf(file.readings);
  subtract(offset, file.readings);
  const bool is_bag = !options.bags.source.files.empty();
  const std::string source = is_bag ? namesOf(options.bags.source.files) : options.readings;
  const bool has_table = !options.access_points.empty();
  LoadedRecording recording{
      settings.config, mapperFor(options, file.readings, offset, settings.config),
      source,          has_table ? options.access_points : source,
      has_table,       offset};
  Mapper& mapper = recording.mapper;
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
      mapper.insertPose(pose.stamp_ns, near(pose.antenna_in_map * options.scale, offset),
                        pose.robot);
    }
  }
  return recording;
}

}  // namespace sfw
