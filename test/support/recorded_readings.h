#pragma once

#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "radio/radio_bins.h"
#include "structure_from_wifi/access_points_io.h"
#include "structure_from_wifi/readings_io.h"

namespace sfw::test {

constexpr const char* kNoRecordings =
    "no recordings: set SFW_SHARED to a folder with data/recordings";

/// A real recording and the positions of its access points.
struct RealRecording {
  std::string name;
  std::string file;  ///< of the readings
  std::vector<Reading> readings;
  std::vector<AccessPoint> access_points;
};

/// A file of the real recordings that are not part of the repository: in $SFW_SHARED, or beside the
/// repository. Empty if it is missing.
inline std::string recordingFile(const std::string& name) {
  const char* given = std::getenv("SFW_SHARED");
  const std::filesystem::path shared =
      given != nullptr ? std::filesystem::path(given)
                       : std::filesystem::path(SFW_SOURCE_DIR) / ".." / "shared";
  const std::filesystem::path file = shared / "data" / "recordings" / name;
  return std::filesystem::exists(file) ? file.string() : "";
}

/// The real recordings with positions of all access points. Empty if there are none.
inline std::vector<RealRecording> realRecordings() {
  std::vector<RealRecording> recordings;
  for (const char* name :
       {"turtlebot_home_a/two_routers", "turtlebot_home_a/one_router", "ble_flat/survey"}) {
    const std::string file = recordingFile(std::string(name) + ".csv");
    if (!file.empty()) {
      const std::string table =
          (std::filesystem::path(file).parent_path() / "access_points.yaml").string();
      recordings.push_back(
          {name, file, readReadings(file).readings, readAccessPoints(table).access_points});
    }
  }
  return recordings;
}

/// The readings of each radio, in order.
inline std::map<Bssid, std::vector<Sample>> samplesByRadio(const std::vector<Reading>& readings) {
  std::map<Bssid, std::vector<Sample>> samples;
  for (const Reading& reading : readings) {
    samples[reading.bssid].push_back({reading.antenna_in_map, reading.rssi_dbm});
  }
  return samples;
}

}  // namespace sfw::test
