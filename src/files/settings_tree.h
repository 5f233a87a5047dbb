#pragma once

#include <yaml-cpp/yaml.h>

#include <map>
#include <string>
#include <vector>

#include "base/validation.h"
#include "files/yaml.h"
#include "structure_from_wifi/config.h"

namespace sfw {

/// Settings in nested YAML maps, read by path ("map/resolution"). It collects all problems of the
/// settings, so that the user sees them at once.
class SettingsTree {
 public:
  /// Another reader handles the key `access_points`.
  /// @param tree  groups of 'name: value'; null for none
  /// @throw InputError if it is anything else
  explicit SettingsTree(const YAML::Node& tree);

  /// Accepts an old name of a setting, with a warning.
  ///
  /// Launch files load the shipped defaults before a user's own settings. So an old name counts
  /// even if the setting is present. It does not count if the setting differs from its default.
  void addOldName(const std::string& old_name, const std::string& name) {
    old_names_[name] = old_name;
  }

  /// Reads the setting into `value`, which keeps its default if the tree has no such setting. A
  /// value of the wrong type is a problem.
  template <class T>
  void read(const std::string& name, T& value) {
    known_.push_back(name);
    const T default_value = value;
    take(name, value);
    const auto old_name = old_names_.find(name);
    if (old_name == old_names_.end() || values_.count(old_name->second) == 0) {
      return;
    }
    const bool counts = value == default_value;
    warnOfOldName(old_name->second, name, counts);
    T old_value = default_value;
    take(old_name->second, old_value);
    value = counts ? old_value : value;
  }

  /// Drops a group that another reader is responsible for.
  void dropGroup(const std::string& group);

  /// The problems found so far. The reader adds its own.
  Problems& problems() { return problems_; }

  /// Names in the tree that no reader has used.
  std::vector<std::string> unknown() const;

  /// A warning for each old name, and one for each unknown name with the nearest known one.
  std::vector<std::string> warnings() const;

 private:
  /// Takes the value out of the tree.
  template <class T>
  void take(const std::string& name, T& value) {
    const auto found = values_.find(name);
    if (found != values_.end()) {
      if (!readScalar(found->second, value)) {
        problems_.add(name + " must be " + typeName(value) + "; it is " + foundText(found->second));
      }
      values_.erase(found);
    }
  }

  void warnOfOldName(const std::string& old_name, const std::string& name, bool counts);
  void flatten(const YAML::Node& node, const std::string& path);
  bool isGroup(const std::string& name) const;
  std::string nearest(const std::string& name) const;

  std::map<std::string, YAML::Node> values_;  // not read yet, by path
  std::vector<std::string> known_;
  std::map<std::string, std::string> old_names_;  // by the present name
  std::vector<std::string> old_name_warnings_;
  Problems problems_;
};

/// Reads the settings of the mapper and adds every problem of validate().
void readSettings(SettingsTree& tree, Config& config);

}  // namespace sfw
