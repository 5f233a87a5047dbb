#include "cli/warnings.h"

#include <iostream>

#include "structure_from_wifi/access_points_io.h"
#include "structure_from_wifi/settings_io.h"

namespace sfw {

void warn(const std::string& text) { std::cerr << "sfw: warning: " << text << '\n'; }

ReadingFile readWithWarnings(const std::string& file, const std::string& path) {
  ReadingFile input = readReadings(file, path);
  for (const auto& [reason, skipped] : input.skipped) {
    warn(file + ": " + std::to_string(skipped.count) + " rows skipped: " + reason +
         " (first: " + skipped.first + ")");
  }
  return input;
}

Config configWithWarnings(const std::string& file) {
  if (file.empty()) {
    return {};
  }
  const ConfigReading reading = readConfig(file);
  for (const std::string& warning : reading.warnings) {
    warn(file + ": " + warning);
  }
  return reading.config;
}

std::vector<AccessPoint> accessPointsWithWarnings(const std::string& file) {
  const AccessPointReading table = readAccessPoints(file);
  for (const std::string& warning : table.warnings) {
    warn(file + ": " + warning);
  }
  return table.access_points;
}

}  // namespace sfw
