#include "cli/map/map_folder.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <set>
#include <system_error>

#include "cli/hash.h"
#include "cli/map/made_map.h"
#include "files/atomic_file.h"
#include "files/text.h"
#include "ros/conversion/ros_settings.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::size_t kUniqueLetters = 6;  // that mkdtemp replaces, after a dot

/// The options as JSON, with what `of` makes of the name of each file.
Json describe(const RecordingOptions& recording,
              const std::function<std::string(const std::string&)>& of) {
  Json bags = Json::array();
  for (const std::string& bag : recording.bags.source.files) {
    bags.push_back(of(bag));
  }
  return {{"readings", of(recording.readings)},
          {"bag", bags},
          {"access_points", of(recording.access_points)},
          {"contacts", of(recording.contacts)},
          {"path", of(recording.path)},
          {"config", of(recording.config)},
          {"scale", recording.scale},
          {"topics", recording.bags.topics},
          {"tf_topic", recording.bags.source.tf_topic},
          {"map_frame", recording.bags.map_frame},
          {"antenna_frame", recording.bags.antenna_frames},
          {"odom_frame", recording.bags.odom_frame}};
}

/// The content of a row file; null if there is none, or if it is damaged.
Json rowFileOf(const std::string& directory) {
  const std::string file = directory + '/' + kRowFile;
  if (!fs::is_regular_file(file)) {
    return nullptr;
  }
  const Json json = Json::parse(readFile(file), nullptr, false);
  return json.is_object() && json.contains("files") && json.contains("made_from") ? json : Json();
}

/// The hash of each file in a directory but the row file.
Json checksumsOf(const std::string& directory) {
  Json checksums = Json::object();
  for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
    const std::string name = entry.path().filename().string();
    if (name != kRowFile) {
      checksums[name] = hexText(hashOfFile(entry.path().string()));
    }
  }
  return checksums;
}

/// A directory under a temporary name that disappears again unless it is renamed.
class TemporaryDirectory {
 public:
  /// @param target  the later name, in the same directory
  explicit TemporaryDirectory(const fs::path& target)
      : name_((target.parent_path() /
               ('.' + target.filename().string() + '.' + std::string(kUniqueLetters, 'X')))
                  .string()) {
    if (mkdtemp(name_.data()) == nullptr) {
      throw std::system_error(errno, std::generic_category(),
                              target.string() + ": cannot be written");
    }
    chmod(name_.c_str(), usualPermissions(0777));
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  ~TemporaryDirectory() {
    std::error_code not_there;
    fs::remove_all(name_, not_there);
  }

  const std::string& name() const { return name_; }

 private:
  std::string name_;
};

/// Renames a whole map to its place. Another worker may have put the same map there meanwhile.
void put(const TemporaryDirectory& made, const std::string& target, const MapOrigin& origin) {
  std::error_code error;
  fs::remove_all(target, error);
  fs::rename(made.name(), target, error);
  if (error && !isWhole(target, origin)) {
    throw std::system_error(error, target + ": cannot be written");
  }
}

}  // namespace

Json optionsJson(const RecordingOptions& recording) {
  return describe(recording, [](const std::string& file) { return file; });
}

MapOrigin originOf(const MapRow& row, const Json& work) {
  MapOrigin origin;
  const auto hashed = [&](const std::string& file) -> std::string {
    if (file.empty()) {
      return "";
    }
    if (!origin.inputs.contains(file)) {
      origin.inputs[file] = hexText(hashOfFile(file));
    }
    return origin.inputs[file];
  };
  origin.made_from = describe(row.recording, hashed);
  origin.made_from["version"] = work.at("version");
  origin.made_from["program"] = work.at("program");
  if (!row.recording.config.empty()) {
    const MappingSettings settings = readMappingSettings(row.recording.config);
    origin.made_from["belief/model"] = hashed(settings.config.belief.model);
  }
  return origin;
}

bool isWhole(const std::string& directory) {
  const Json row = rowFileOf(directory);
  return !row.is_null() && row["files"] == checksumsOf(directory);
}

bool isWhole(const std::string& directory, const MapOrigin& origin) {
  const Json row = rowFileOf(directory);
  return !row.is_null() && row["made_from"] == origin.made_from && isWhole(directory);
}

void makeRow(const MapRow& row, const MapOrigin& origin, const std::string& directory) {
  const std::string target = directory + '/' + row.name;
  if (fs::exists(fs::symlink_status(target)) && !fs::exists(target + '/' + kRowFile)) {
    throw InputError(target + ": is in the way, and no map of a list; move it to another place");
  }
  const TemporaryDirectory made(target);
  makeMap(row.recording, made.name());
  const Json json{{"made_from", origin.made_from}, {"files", checksumsOf(made.name())}};
  writeAtomically(made.name() + '/' + kRowFile,
                  json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
  put(made, target, origin);
}

void removeUnfinished(const std::vector<MapRow>& rows, const std::string& directory) {
  constexpr std::size_t kEnd = kUniqueLetters + 1;
  std::set<std::string> names;
  for (const MapRow& row : rows) {
    names.insert("." + row.name);
  }
  std::vector<fs::path> unfinished;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
    const std::string name = entry.path().filename().string();
    if (name.size() > kEnd && name[name.size() - kEnd] == '.' &&
        names.count(name.substr(0, name.size() - kEnd)) != 0) {
      unfinished.push_back(entry.path());
    }
  }
  for (const fs::path& path : unfinished) {
    fs::remove_all(path);
  }
}

}  // namespace sfw
