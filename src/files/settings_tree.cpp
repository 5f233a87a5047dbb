#include "files/settings_tree.h"

#include <algorithm>

#include "base/old_name.h"
#include "files/text.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// Whether a key beside the groups of settings belongs to the table of access points.
bool isTable(const std::string& key) {
  return key == "access_points" || key == "access_points_file";
}

std::string lastPart(const std::string& name) { return name.substr(name.rfind('/') + 1); }

}  // namespace

SettingsTree::SettingsTree(const YAML::Node& tree) {
  if (!tree || tree.IsNull()) {
    return;
  }
  if (!tree.IsMap()) {
    throw InputError("settings must be groups of 'name: value'");
  }
  flatten(tree, "");
}

/// Settings have two parts at most. A deeper value belongs to no setting. It may be endless, since
/// a YAML alias can contain itself.
void SettingsTree::flatten(const YAML::Node& node, const std::string& path) {
  if (!node.IsMap() || path.find('/') != std::string::npos) {
    values_[path] = node;
    return;
  }
  for (const auto& entry : node) {
    if (!entry.first.IsScalar()) {
      throw InputError("settings must be groups of 'name: value'");
    }
    const std::string& key = entry.first.Scalar();
    if (!path.empty() || !isTable(key)) {
      flatten(entry.second, path.empty() ? key : path + "/" + key);
    }
  }
}

void SettingsTree::warnOfOldName(const std::string& old_name, const std::string& name,
                                 bool counts) {
  old_name_warnings_.push_back(counts ? oldNameWarning(old_name, name)
                                      : old_name + " is now called " + name +
                                            ", which is set too: the value of " + old_name +
                                            " is ignored; remove it");
}

void SettingsTree::dropGroup(const std::string& group) {
  const std::string prefix = group + "/";
  values_.erase(group);
  values_.erase(values_.lower_bound(prefix), values_.lower_bound(group + char('/' + 1)));
}

std::vector<std::string> SettingsTree::unknown() const {
  std::vector<std::string> names;
  for (const auto& value : values_) {
    names.push_back(value.first);
  }
  return names;
}

bool SettingsTree::isGroup(const std::string& name) const {
  return std::any_of(known_.begin(), known_.end(),
                     [&](const std::string& known) { return known.rfind(name + "/", 0) == 0; });
}

std::string SettingsTree::nearest(const std::string& name) const {
  std::string nearest;
  std::size_t least = std::string::npos;
  for (const std::string& known : known_) {
    // The group may be missing.
    const std::size_t distance =
        std::min(editDistance(name, known), editDistance(name, lastPart(known)));
    if (distance < least) {
      least = distance;
      nearest = known;
    }
  }
  return nearest;
}

std::vector<std::string> SettingsTree::warnings() const {
  std::vector<std::string> warnings = old_name_warnings_;
  for (const std::string& name : unknown()) {
    const std::string group = lastPart(name);
    if (isGroup(name)) {
      warnings.push_back(name + " is a group of settings and has no value");
    } else if (isGroup(group)) {
      warnings.push_back(name + " is not read: the group " + group + " must stand at the top");
    } else {
      warnings.push_back(name + " is not a setting; did you mean " + nearest(name) + "?");
    }
  }
  return warnings;
}

}  // namespace sfw
