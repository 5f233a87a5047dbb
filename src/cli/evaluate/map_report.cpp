#include "cli/evaluate/map_report.h"

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/warnings.h"
#include "files/text.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/settings_io.h"

namespace sfw {
namespace {

using Json = nlohmann::json;

std::string reportBeside(const std::string& map) {
  return (std::filesystem::path(map).parent_path() / "report.json").string();
}

/// A part of the report; null if there is none.
Json partOf(const std::string& file, const char* key) {
  if (!std::filesystem::exists(file)) {
    return {};
  }
  constexpr bool kThrows = false;
  const Json report = Json::parse(readFile(file), nullptr, kThrows);
  return report.is_object() && report.contains(key) ? report[key] : Json();
}

}  // namespace

std::map<Bssid, Position> reportedPositions(const std::string& map) {
  std::map<Bssid, Position> positions;
  try {
    for (const Json& access_point : partOf(reportBeside(map), "access_points")) {
      const auto bssid = Bssid::parse(access_point.at("bssid").get<std::string>());
      if (bssid && access_point.contains("x")) {
        positions[*bssid] = {access_point.at("x").get<double>(),
                             access_point.at("y").get<double>()};
      }
    }
  } catch (const Json::exception&) {
    positions.clear();  // another program's report
  }
  return positions;
}

bool isReportedWithoutTable(const std::string& map) {
  return partOf(reportBeside(map), "has_table") == Json(false);
}

std::optional<Config> reportedSettings(const std::string& map) {
  const std::string file = reportBeside(map);
  const Json settings = partOf(file, "settings");
  if (!settings.is_object()) {
    return std::nullopt;
  }
  try {
    const ConfigReading reading = configFromYaml(YAML::Load(settings.dump()));
    for (const std::string& warning : reading.warnings) {
      warn(file + ": " + warning);
    }
    return reading.config;
  } catch (const InputError& error) {
    throw InputError(file + ": " + error.what() + "; name the settings of the map by --config");
  }
}

}  // namespace sfw
