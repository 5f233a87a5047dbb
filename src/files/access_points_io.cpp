#include "structure_from_wifi/access_points_io.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "base/validation.h"
#include "files/text.h"
#include "files/yaml.h"

namespace sfw {
namespace {

constexpr char kTableKey[] = "access_points";
constexpr char kFarthest[] = "1e8";  // metres; no map projection has larger numbers
constexpr char kLargest[] = "1e6";   // of other numbers
constexpr double kLeastSdM = 0.01;   // no tape measures better, nor any estimate
constexpr const char* kKeys[] = {"bssid", "x", "y", "z", "name", "tx_dbm", "position_sd"};

/// Reads an optional or required number of an access point; adds a problem if it is unusable.
/// @param largest  of its absolute value, as the problem names it: "1e6"
std::optional<double> readNumber(const YAML::Node& entry, const char* key, bool required,
                                 const char* largest, const std::string& where,
                                 std::vector<std::string>& problems) {
  const YAML::Node node = entry[key];
  if (!node) {
    if (required) {
      problems.push_back(where + ": '" + key + "' is missing");
    }
    return std::nullopt;
  }
  double value = 0.0;
  if (!readScalar(node, value) || !(std::abs(value) <= *parseNumber(largest))) {
    const bool has_comma = node.IsScalar() && node.Scalar().find(',') != std::string::npos;
    problems.push_back(where + ": '" + key + "' must be a number from -" + largest + " to " +
                       largest + (has_comma ? ", with a decimal point" : "") + "; it is " +
                       foundText(node));
    return std::nullopt;
  }
  return value;
}

/// Adds unknown keys to the warnings, or to the problems if they show that a number is cut.
void tellUnknownKeys(const YAML::Node& entry, const std::string& where,
                     std::vector<std::string>& problems, std::vector<std::string>& warnings) {
  const auto is_known = [](const std::string& key) {
    return std::find(std::begin(kKeys), std::end(kKeys), key) != std::end(kKeys);
  };
  for (const auto& field : entry) {
    const std::string key = field.first.IsScalar() ? field.first.Scalar() : "a list or map";
    if (is_known(key)) {
      continue;
    }
    if (parseNumber(key)) {  // {x: 2,6} has the keys x and 6
      problems.push_back(where + ": '" + key +
                         "' follows a comma within a number; write a decimal point");
    } else {
      warnings.push_back(
          where + ": '" + key +
          "' is not read; an access point has bssid, x, y, position_sd, z, name and tx_dbm");
    }
  }
}

/// Reads the BSSID; adds a problem if it is missing or malformed.
Bssid readBssid(const YAML::Node& entry, const std::string& where,
                std::vector<std::string>& problems) {
  if (!entry["bssid"]) {
    problems.push_back(where + ": 'bssid' is missing");
    return {};
  }
  std::string text;
  readScalar(entry["bssid"], text);
  const std::optional<Bssid> bssid = Bssid::parse(text);
  if (!bssid) {
    // rosparam reads YAML 1.1, in which 52:54:00:12:34:56 is a number of base 60.
    const char* const advice = parseNumber(text) ? ": YAML reads it as a number, so quote it" : "";
    problems.push_back(where + ": 'bssid' must look like '02:00:00:00:00:01'; it is " +
                       inQuotes(text) + advice);
  }
  return bssid.value_or(Bssid());
}

/// Reads the standard deviation of the position; adds a problem if it is unusable.
std::optional<double> readPositionSd(const YAML::Node& entry, bool position_known,
                                     const std::string& where, std::vector<std::string>& problems) {
  const std::optional<double> sd_m =
      readNumber(entry, "position_sd", false, kLargest, where, problems);
  if (sd_m && *sd_m < kLeastSdM) {
    problems.push_back(where + ": 'position_sd' must be at least 0.01 m; leave it out if the " +
                       "position is exact");
  } else if (sd_m && !position_known) {
    problems.push_back(where + ": 'position_sd' needs x and y, whose standard deviation it is");
  }
  return sd_m;
}

AccessPoint readAccessPoint(const YAML::Node& entry, const std::string& where,
                            std::vector<std::string>& problems,
                            std::vector<std::string>& warnings) {
  AccessPoint access_point;
  if (!entry.IsMap()) {
    problems.push_back(where + ": must be a map with bssid and, if known, x and y");
    return access_point;
  }
  tellUnknownKeys(entry, where, problems, warnings);
  access_point.bssid = readBssid(entry, where, problems);
  access_point.position_known = entry["x"] || entry["y"];
  if (access_point.position_known) {
    access_point.position.x() =
        readNumber(entry, "x", true, kFarthest, where, problems).value_or(0.0);
    access_point.position.y() =
        readNumber(entry, "y", true, kFarthest, where, problems).value_or(0.0);
  }
  access_point.position_sd_m = readPositionSd(entry, access_point.position_known, where, problems);
  access_point.height_m = readNumber(entry, "z", false, kLargest, where, problems);
  access_point.tx_dbm = readNumber(entry, "tx_dbm", false, kLargest, where, problems);
  if (entry["name"]) {
    readScalar(entry["name"], access_point.name);
  }
  return access_point;
}

}  // namespace

AccessPointReading accessPointsFromYaml(const YAML::Node& table) {
  if (!table || !table.IsSequence()) {
    throw InputError("access_points must be a list of {bssid, x, y}");
  }
  std::vector<std::string> problems;
  AccessPointReading reading;
  std::set<Bssid> seen;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const std::string where = "access_points[" + std::to_string(i) + "]";
    const std::size_t before = problems.size();
    const AccessPoint access_point = readAccessPoint(table[i], where, problems, reading.warnings);
    if (problems.size() == before && !seen.insert(access_point.bssid).second) {
      problems.push_back(where + ": " + access_point.bssid.str() + " is in the list twice");
    }
    reading.access_points.push_back(access_point);
  }
  if (!problems.empty()) {  // a misspelt key may be the cause
    problems.insert(problems.end(), reading.warnings.begin(), reading.warnings.end());
  }
  throwIfAny(problems);
  return reading;
}

AccessPointReading readAccessPoints(const std::string& file) {
  return readYaml(file, [](const YAML::Node& node) {
    if (node.IsMap() && !node[kTableKey] && node.size() > 0 && node.begin()->first.IsScalar()) {
      throw InputError("the key 'access_points' is missing; the file has '" +
                       node.begin()->first.Scalar() + "'");
    }
    return accessPointsFromYaml(node.IsMap() ? node[kTableKey] : YAML::Node());
  });
}

std::string accessPointsYaml(const std::vector<AccessPoint>& access_points) {
  YAML::Emitter yaml;
  yaml << YAML::BeginMap << YAML::Key << kTableKey << YAML::Value << YAML::BeginSeq;
  for (const AccessPoint& access_point : access_points) {
    yaml << YAML::Flow << YAML::BeginMap;
    yaml << YAML::Key << "bssid" << YAML::Value << YAML::DoubleQuoted << access_point.bssid.str();
    yaml << YAML::Key << "name" << YAML::Value << YAML::DoubleQuoted << access_point.name;
    if (access_point.position_known) {
      yaml << YAML::Key << "x" << YAML::Value << exactText(access_point.position.x());
      yaml << YAML::Key << "y" << YAML::Value << exactText(access_point.position.y());
      if (access_point.position_sd_m) {
        yaml << YAML::Key << "position_sd" << YAML::Value << exactText(*access_point.position_sd_m);
      }
    }
    if (access_point.height_m) {
      yaml << YAML::Key << "z" << YAML::Value << exactText(*access_point.height_m);
    }
    if (access_point.tx_dbm) {
      yaml << YAML::Key << "tx_dbm" << YAML::Value << exactText(*access_point.tx_dbm);
    }
    yaml << YAML::EndMap;
  }
  yaml << YAML::EndSeq << YAML::EndMap;
  return std::string(yaml.c_str()) + "\n";
}

}  // namespace sfw
