#include "structure_from_wifi/settings_io.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/validation.h"
#include "files/text.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

constexpr char kAccessPointsKey[] = "access_points";

/// Reads a scalar as the member's type; text for numbers is a wrong type, so is 2.5 for an integer.
bool readScalar(const YAML::Node& node, double& value) {
  const auto number = node.IsScalar() ? parseNumber(node.Scalar()) : std::nullopt;
  value = number.value_or(value);
  return number.has_value();
}

bool readScalar(const YAML::Node& node, std::int64_t& value) {
  double number = 0.0;
  if (!readScalar(node, number) || number != std::floor(number) || std::abs(number) > 1e15) {
    return false;
  }
  value = static_cast<std::int64_t>(number);
  return true;
}

bool readScalar(const YAML::Node& node, std::string& value) {
  if (!node.IsScalar()) {
    return false;
  }
  value = node.Scalar();
  return true;
}

const char* typeName(double) { return "a number"; }
const char* typeName(std::int64_t) { return "a whole number"; }
const char* typeName(const std::string&) { return "a text"; }

/// Every value under a node by its path of two parts at most, as settings have: what stands deeper
/// is no value of any setting, and may be endless (a YAML alias can hold itself).
void flatten(const YAML::Node& node, const std::string& path,
             std::map<std::string, YAML::Node>& leaves) {
  if (!node.IsMap() || path.find('/') != std::string::npos) {
    leaves[path] = node;
    return;
  }
  for (const auto& entry : node) {
    if (!entry.first.IsScalar()) {
      throw InputError("settings must be groups of 'name: value'");
    }
    const std::string& key = entry.first.Scalar();
    if (!path.empty() || key != kAccessPointsKey) {
      flatten(entry.second, path.empty() ? key : path + "/" + key, leaves);
    }
  }
}

std::string nearestSetting(const std::string& name) {
  std::string nearest;
  std::size_t least = std::string::npos;
  const Config defaults;
  forEachSetting(defaults, [&](const std::string& known, const auto&) {
    // The group may be what was left out.
    const std::string last = known.substr(known.rfind('/') + 1);
    const std::size_t distance = std::min(editDistance(name, known), editDistance(name, last));
    if (distance < least) {
      least = distance;
      nearest = known;
    }
  });
  return nearest;
}

/// Settings that had another name in the release before: its old name, then its name now.
constexpr std::pair<const char*, const char*> kRenamed[] = {
    {"inference/footprint_radius", "path/footprint_radius"},
    {"inference/max_gap", "path/max_gap"},
    {"inference/wall_density", "k_visibility/wall_prior"},
    {"inference/wall_thickness", "k_visibility/wall_thickness"},
    {"rssi/filter", "k_visibility/filter"},
    {"rssi/max_walls", "k_visibility/max_wall_count"},
    {"rssi/min_wall_loss", "k_visibility/min_wall_loss"},
    {"rssi/path_loss_exponent", "k_visibility/path_loss_exponent"},
    {"rssi/walls", "k_visibility/wall_count"},
    {"rssi/window", "k_visibility/window"},
    {"tomography/bin", "tomography/bin_size"},
    {"tomography/directions", "tomography/wall_directions"},
    {"tomography/members", "tomography/ensemble_size"},
    {"tomography/saturation", "tomography/max_total_wall_loss"},
    {"tomography/sparsity", "tomography/l1_weight"},
    {"tomography/straightness", "tomography/smoothness_weight"},
    {"tomography/unexplained", "tomography/nugget"},
};

/// Whether a setting is absent or has its default value.
bool isDefault(const std::map<std::string, YAML::Node>& leaves, const std::string& name) {
  const auto leaf = leaves.find(name);
  bool same = leaf == leaves.end();
  const Config defaults;
  forEachSetting(defaults, [&](const std::string& known, const auto& value) {
    auto given = value;
    same = same || (known == name && readScalar(leaf->second, given) && given == value);
  });
  return same;
}

/// Moves values under old names to the names of now, with a warning for each.
///
/// Launch files load the shipped defaults before a user's own settings. So an old name counts even
/// beside its new name, unless the new name was given another value than its default.
void renameOldSettings(std::map<std::string, YAML::Node>& leaves,
                       std::vector<std::string>& warnings) {
  for (const auto& [old_name, name] : kRenamed) {
    const auto old_leaf = leaves.find(old_name);
    if (old_leaf == leaves.end()) {
      continue;
    }
    const std::string renamed = std::string(old_name) + " is now called " + name;
    if (isDefault(leaves, name)) {
      leaves[name] = old_leaf->second;
      warnings.push_back(renamed + "; rename it, the next release ignores the old name");
    } else {
      warnings.push_back(renamed + ", which is set too: the value of " + old_name +
                         " is ignored; remove it");
    }
    leaves.erase(old_name);
  }
}

/// Whether settings stand below a name.
bool isGroup(const std::string& name) {
  bool group = false;
  const Config defaults;
  forEachSetting(defaults, [&](const std::string& known, const auto&) {
    group = group || known.rfind(name + "/", 0) == 0;
  });
  return group;
}

/// What to tell of a name that no setting has.
std::string unknownText(const std::string& name) {
  if (isGroup(name)) {
    return name + " is a group of settings and has no value";
  }
  const std::string last = name.substr(name.rfind('/') + 1);
  if (isGroup(last)) {
    return name + " is not read: the group " + last + " must stand at the top";
  }
  return name + " is not a setting; did you mean " + nearestSetting(name) + "?";
}

YAML::Node loadYaml(const std::string& file) {
  try {
    return YAML::Load(readFile(file));
  } catch (const YAML::Exception& error) {
    throw InputError(file + ": line " + std::to_string(error.mark.line + 1) + ": " + error.msg);
  }
}

/// Puts the file's name before what went wrong in it.
template <class Read>
auto named(const std::string& file, Read&& read) {
  const YAML::Node node = loadYaml(file);
  try {
    return read(node);
  } catch (const InputError& error) {
    throw InputError(file + ": " + error.what());
  }
}

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
  static const std::set<std::string> kKnown{"bssid", "x", "y", "z", "name", "tx_dbm"};
  for (const auto& field : entry) {
    if (!field.first.IsScalar() || kKnown.count(field.first.Scalar()) == 0) {
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
    problems.push_back(where + ": must be a map with bssid and, if they are known, x and y");
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

ConfigReading configFromYaml(const YAML::Node& node) {
  ConfigReading reading;
  if (!node || node.IsNull()) {
    return reading;
  }
  if (!node.IsMap()) {
    throw InputError("settings must be groups of 'name: value'");
  }
  std::map<std::string, YAML::Node> leaves;
  flatten(node, "", leaves);
  renameOldSettings(leaves, reading.warnings);
  std::vector<std::string> problems;
  forEachSetting(reading.config, [&](const char* name, auto& value) {
    const auto leaf = leaves.find(name);
    if (leaf == leaves.end()) {
      return;
    }
    if (!readScalar(leaf->second, value)) {
      problems.push_back(std::string(name) + " must be " + typeName(value));
    }
    leaves.erase(leaf);
  });
  for (const auto& leaf : leaves) {
    reading.warnings.push_back(unknownText(leaf.first));
  }
  const std::vector<std::string> broken_rules = validate(reading.config);
  problems.insert(problems.end(), broken_rules.begin(), broken_rules.end());
  throwIfAny(problems);
  return reading;
}

ConfigReading readConfig(const std::string& file) { return named(file, configFromYaml); }

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
      problems.push_back(where + ": " + access_point.bssid.str() + " stands in the list twice");
    }
    reading.access_points.push_back(access_point);
  }
  throwIfAny(problems);
  return reading;
}

AccessPointReading readAccessPoints(const std::string& file) {
  return named(file, [](const YAML::Node& node) {
    return accessPointsFromYaml(node.IsMap() ? node[kAccessPointsKey] : YAML::Node());
  });
}

}  // namespace sfw
