#include "cli/map/map_list.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "base/validation.h"
#include "files/yaml.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

namespace fs = std::filesystem;

constexpr char kName[] = "name";
const char* const kFiles[] = {"readings", "bag", "access_points", "contacts", "path", "config"};

/// The longest name: most file systems allow 255 bytes, and an unfinished map has a longer one.
constexpr std::size_t kLongest = 200;

std::string nameOf(const YAML::Node& row) {
  std::string name;
  if (!row[kName] || !readScalar(row[kName], name) || name.empty()) {
    throw InputError("'name' is missing; it names the directory of the map");
  }
  const bool has_controls = std::any_of(name.begin(), name.end(), [](char c) {
    return static_cast<unsigned char>(c) < ' ' || c == '\x7f';
  });
  if (name.find('/') != std::string::npos || name.front() == '.' || has_controls ||
      name.size() > kLongest) {
    throw InputError(
        "'name' must be a directory's name without '/', control characters and a "
        "leading '.', of at most " +
        std::to_string(kLongest) + " bytes; it is '" + name + "'");
  }
  return name;
}

/// The values of a key: a list, or one text.
std::vector<std::string> valuesOf(const std::string& key, const YAML::Node& node) {
  std::vector<std::string> values;
  const auto add = [&](const YAML::Node& value) {
    std::string text;
    if (!readScalar(value, text)) {
      throw InputError("'" + key + "' must be a text or a list of texts");
    }
    values.push_back(text);
  };
  if (node.IsSequence()) {
    std::for_each(node.begin(), node.end(), add);
  } else {
    add(node);
  }
  return values;
}

/// The row as a command line, which has the same rules and the same errors.
std::vector<std::string> argumentsOf(const YAML::Node& row, const fs::path& folder) {
  std::vector<std::string> arguments;
  for (const auto& entry : row) {
    const auto key = entry.first.as<std::string>();
    if (key == kName) {
      continue;
    }
    const bool is_file = std::find(std::begin(kFiles), std::end(kFiles), key) != std::end(kFiles);
    std::string option = "--" + key;
    std::replace(option.begin(), option.end(), '_', '-');
    for (const std::string& value : valuesOf(key, entry.second)) {
      arguments.push_back(option + '=' +
                          (is_file ? (folder / value).lexically_normal().string() : value));
    }
  }
  return arguments;
}

MapRow rowOf(const YAML::Node& row, const fs::path& folder, const RecordingOptions& shared) {
  if (!row.IsMap()) {
    throw InputError("a recording must be a map: {name: monday, readings: monday.csv}");
  }
  MapRow made{nameOf(row), shared};
  Options options("map", "", argumentsOf(row, folder));
  made.recording.declare(options);
  options.parse();
  made.recording.check();
  return made;
}

/// Adds a problem of a row; of many alike, the first ones are enough.
void addTo(Problems& problems, const std::string& text) {
  constexpr std::size_t kMostTold = 20;
  if (problems.list().size() < kMostTold) {
    problems.add(text);
  } else if (problems.list().size() == kMostTold) {
    problems.add("and more");
  }
}

}  // namespace

std::vector<MapRow> readMapList(const std::string& file, const RecordingOptions& shared) {
  const YAML::Node root = loadYaml(file);
  if (!root.IsSequence() || root.size() == 0) {
    throw InputError(file + ": must be a list of recordings: - {name: monday, readings: m.csv}");
  }
  std::vector<MapRow> rows;
  std::map<std::string, std::string> lines;  // by name
  Problems problems;
  for (const YAML::Node& node : root) {
    const std::string line = "line " + std::to_string(node.Mark().line + 1);
    try {
      rows.push_back(rowOf(node, fs::path(file).parent_path(), shared));
      const std::string& name = rows.back().name;
      if (const auto [known, is_new] = lines.emplace(name, line); !is_new) {
        throw InputError("the name '" + name + "' is that of " + known->second +
                         "; each map needs a name of its own");
      }
    } catch (const InputError& error) {
      addTo(problems, file + ": " + line + ": " + error.what());
    } catch (const YAML::Exception& error) {
      addTo(problems, file + ": " + line + ": " + error.msg);
    }
  }
  problems.throwIfAny();
  return rows;
}

}  // namespace sfw
