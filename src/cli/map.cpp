#include <chrono>
#include <iostream>
#include <memory>

#include "commands.h"
#include "structure_from_wifi/config_reader.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/map_files.h"
#include "structure_from_wifi/mapper.h"
#include "structure_from_wifi/reading_io.h"

namespace sfw {
namespace {

struct Options {
  std::string readings;
  std::string access_points;
  std::string contacts;
  std::string config;
  std::string output;
};

void warn(const std::string& text) { std::cerr << "sfw: warning: " << text << '\n'; }

Config loadConfig(const std::string& file) {
  if (file.empty()) {
    return {};
  }
  ConfigReading reading = readConfig(file);
  for (const std::string& warning : reading.warnings) {
    warn(file + ": " + warning);
  }
  return reading.config;
}

void insertReadings(const std::string& file, Mapper& mapper) {
  const ReadingFile input = readReadings(file);
  for (const auto& [reason, skipped] : input.skipped) {
    warn(file + ": " + std::to_string(skipped.count) + " rows skipped: " + reason + " (first: " +
         skipped.first + ")");
  }
  for (const Reading& reading : input.readings) {
    mapper.insert(reading);
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

void run(const Options& options) {
  const auto start = std::chrono::steady_clock::now();
  const Config config = loadConfig(options.config);
  Mapper mapper(config, readAccessPoints(options.access_points));
  insertReadings(options.readings, mapper);
  if (!options.contacts.empty()) {
    for (const Contact& contact : readContacts(options.contacts)) {
      mapper.insert(contact);
    }
  }
  reportRejections(options.readings, mapper.rejections());
  if (mapper.readings().empty()) {
    throw InputError(options.readings + ": no reading can be used: see the warnings above");
  }
  writeMapFiles(*mapper.infer(), config, options.output);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  std::cerr << "sfw: wrote the map to " << options.output << " in "
            << static_cast<int>(elapsed.count() * 1000) << " ms\n";
}

}  // namespace

void addMapCommand(CLI::App& sfw) {
  const auto options = std::make_shared<Options>();
  CLI::App* map = sfw.add_subcommand("map", "Make a map from a recording.");
  map->add_option("--readings", options->readings,
                  "CSV with the columns stamp, x, y, bssid, rssi_dbm")
      ->required();
  map->add_option("--access-points", options->access_points,
                  "YAML: access_points: [{bssid, x, y, z?, name?, tx_dbm?}]")
      ->required();
  map->add_option("--contacts", options->contacts,
                  "CSV with the columns stamp, x, y: obstacles that the robot touched");
  map->add_option("--config", options->config, "settings as in config/mapping.yaml");
  map->add_option("--output", options->output, "directory for the map's files")->required();
  map->callback([options] { run(*options); });
}

}  // namespace sfw
