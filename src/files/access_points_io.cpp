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
constexpr const char* kKeys[] = {"bssid", "x", "y", "z", "name", "tx_dbm"};

/// Reads an optional or required number of an access point; adds a problem if it is unusable.
std::optional<double> readNumber(const YAML::Node& entry, const char* key, bool required,
                                 const std::string& where, std::vector<std::string>& problems) {
  const YAML::Node node = entry[key];
  if (!node) {
    if (required) {
      problems.push_back(where + ": '" + key + "' is missing");
    }
    return std::nullopt;
  }
  double value = 0.0;
  if (!readScalar(node, value) || !std::isfinite(value) || std::abs(value) > 1e6) {
    problems.push_back(where + ": '" + key + "' must be a number from -1e6 to 1e6");
    return std::nullopt;
  }
  return value;
}

void warnOfUnknownKeys(const YAML::Node& entry, const std::string& where,
                       std::vector<std::string>& warnings) {
  const auto is_known = [](const std::string& key) {
    return std::find(std::begin(kKeys), std::end(kKeys), key) != std::end(kKeys);
  };
  for (const auto& field : entry) {
    if (!field.first.IsScalar() || !is_known(field.first.Scalar())) {
      const std::string key = field.first.IsScalar() ? field.first.Scalar() : "a list or map";
      warnings.push_back(where + ": '" + key +
                         "' is not read; an access point has bssid, x, y, z, name and tx_dbm");
    }
  }
}

AccessPoint readAccessPoint(const YAML::Node& entry, const std::string& where,
                            std::vector<std::string>& problems,
                            std::vector<std::string>& warnings) {
  AccessPoint access_point;
  if (!entry.IsMap()) {
    problems.push_back(where + ": must be a map with bssid and, if known, x and y");
    return access_point;
  }
  warnOfUnknownKeys(entry, where, warnings);
  std::string text;
  const bool has_bssid = entry["bssid"] && readScalar(entry["bssid"], text);
  const std::optional<Bssid> bssid = Bssid::parse(text);
  if (!has_bssid || !bssid) {
    problems.push_back(where + ": 'bssid' must look like '02:00:00:00:00:01'; it is '" + text +
                       "'");
  } else {
    access_point.bssid = *bssid;
  }
  access_point.position_known = entry["x"] || entry["y"];
  if (access_point.position_known) {
    access_point.position.x() = readNumber(entry, "x", true, where, problems).value_or(0.0);
    access_point.position.y() = readNumber(entry, "y", true, where, problems).value_or(0.0);
  }
  access_point.height_m = readNumber(entry, "z", false, where, problems);
  access_point.tx_dbm = readNumber(entry, "tx_dbm", false, where, problems);
  if (entry["name"]) {
    readScalar(entry["name"], access_point.name);
  }
  return access_point;
}

}  // namespace

AccessPointReading accessPointsFromYaml(const YAML::Node& table) {
  if (!table || !table.IsSequence() || table.size() == 0) {
    throw InputError("access_points must be a list with at least one {bssid, x, y}");
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
  throwIfAny(problems);
  return reading;
}

AccessPointReading readAccessPoints(const std::string& file) {
  return readYaml(file, [](const YAML::Node& node) {
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
