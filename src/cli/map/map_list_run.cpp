#include "cli/map/map_list_run.h"

#include <chrono>
#include <iostream>
#include <map>
#include <new>
#include <system_error>

#include "base/failure.h"
#include "base/validation.h"
#include "cli/hash.h"
#include "cli/map/map_folder.h"
#include "cli/map/map_list.h"
#include "cli/shards/work_lock.h"
#include "files/atomic_file.h"
#include "files/text.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

using Json = nlohmann::json;

Json workOfList(const MapListRun& run) {
  Json work = workOf("map");
  work["list"] = hexText(hashOf(readFile(run.list)));
  work["options"] = optionsJson(run.shared);
  return work;
}

std::string rowFile(const std::string& directory, const std::string& name) {
  return directory + '/' + name + '/' + kRowFile;
}

/// @throw InputError naming each row without a map, as the list lacks them.
void requireNoFailure(const Part& part) {
  std::vector<std::string> failures;
  for (const Json& failure : part.failures) {
    failures.push_back(failure.at("name").get<std::string>() + ": " +
                       failure.at("reason").get<std::string>());
  }
  requireNone(failures, part.failures.size() + part.results.size(), "could not be mapped");
}

void writeIndex(const Part& part, const std::string& directory) {
  Json index{{"maps", Json::array()}, {"failures", Json::array()}};
  for (const Json& result : part.results) {
    index["maps"].push_back({{"name", result.at("name")}, {"row", result.at("checksum")}});
  }
  for (const Json& failure : part.failures) {
    index["failures"].push_back({{"name", failure.at("name")}, {"reason", failure.at("reason")}});
  }
  const std::string file = directory + "/maps.json";
  writeAtomically(file, index.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
  std::cerr << "sfw: " << file << " names " << part.results.size() << " maps\n";
}

/// The rows of a shard, mapped one after the other.
class MapList {
 public:
  explicit MapList(const MapListRun& run)
      : run_(run),
        rows_(readMapList(run.list, run.shared)),
        lock_(run.directory, run.shard, [this] { removeUnfinished(rows_, run_.directory); }) {
    part_.work = workOfList(run);
    part_.rows = rows_.size();
  }

  const Part& make() {
    for (const std::size_t row : run_.shard.rowsOf(rows_.size())) {
      Json entry{{"row", row}, {"name", rows_[row].name}};
      try {
        makeRow(rows_[row], entry);
        part_.results.push_back(entry);
      } catch (const std::system_error&) {
        throw;  // no later map could be written either
      } catch (const std::exception& error) {
        entry["reason"] = reasonOf(error);
        part_.failures.push_back(entry);
        std::cerr << "sfw: " << rows_[row].name << ": " << reasonOf(error) << '\n';
      }
    }
    if (whole_ > 0) {
      std::cerr << "sfw: " << whole_ << " of " << part_.results.size() + part_.failures.size()
                << " maps were whole already\n";
    }
    return part_;
  }

 private:
  void makeRow(const MapRow& row, Json& entry) {
    const auto start = std::chrono::steady_clock::now();
    const MapOrigin origin = originOf(row, part_.work);
    const std::string target = run_.directory + '/' + row.name;
    if (isWhole(target, origin)) {
      ++whole_;
    } else {
      sfw::makeRow(row, origin, run_.directory);
      const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
      std::cerr << "sfw: wrote the map to " << target << " in "
                << static_cast<int>(elapsed.count() * 1000) << " ms, row "
                << entry["row"].get<std::size_t>() + 1 << " of " << rows_.size() << '\n';
    }
    entry["inputs"] = origin.inputs;
    entry["checksum"] = hexText(hashOfFile(rowFile(run_.directory, row.name)));
  }

  const MapListRun run_;
  const std::vector<MapRow> rows_;
  const WorkLock lock_;
  Part part_;
  std::size_t whole_ = 0;
};

/// Rows of different machines must not come from different contents of one file.
void addChangedInputs(const Part& part, Problems& problems) {
  std::map<std::string, std::pair<Json, std::string>> known;  // hash, name of the row
  for (const Json& result : part.results) {
    const auto name = result.at("name").get<std::string>();
    for (const auto& [file, hash] : result.at("inputs").items()) {
      const auto [first, is_new] = known.try_emplace(file, hash, name);
      if (!is_new && first->second.first != hash) {
        problems.add(name + ": was made from another " + file + " than " + first->second.second +
                     "; run its shard again");
      }
    }
  }
}

}  // namespace

void runMapList(const MapListRun& run) {
  MapList list(run);
  const Part& part = list.make();
  if (run.shard.count == 1) {
    writeIndex(part, run.directory);
  } else {
    writePart(part, run.shard, run.directory);
  }
  requireNoFailure(part);
}

void finishMapList(const Part& part, const std::string& directory) {
  Problems problems;
  for (const Json& result : part.results) {
    const auto name = result.at("name").get<std::string>();
    const std::string target = directory + '/' + name;
    if (!isWhole(target) ||
        hexText(hashOfFile(rowFile(directory, name))) != result.at("checksum")) {
      problems.add(target + ": the map is missing, damaged or another one; run its shard again");
    }
  }
  addChangedInputs(part, problems);
  problems.throwIfAny();
  writeIndex(part, directory);
  requireNoFailure(part);
}

}  // namespace sfw
