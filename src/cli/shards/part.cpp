#include "cli/shards/part.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <regex>
#include <tuple>

#include "base/validation.h"
#include "cli/hash.h"
#include "files/atomic_file.h"
#include "files/text.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/version.h"

namespace sfw {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct NamedPart {
  std::string file;  // its name
  Shard shard;
  Part part;
};

/// The shard that a part file belongs to; nothing for other files.
std::optional<Shard> shardOf(const std::string& name) {
  const std::regex pattern("shard-([0-9]+)-of-([0-9]+)\\.json");
  std::smatch match;
  if (!std::regex_match(name, match, pattern)) {
    return std::nullopt;
  }
  return parseShard(match[1].str() + '/' + match[2].str());
}

Part readPart(const std::string& file) {
  try {
    const Json json = Json::parse(readFile(file));
    Part part{json.at("work"), json.at("rows").get<std::size_t>(), json.at("results"),
              json.at("failures")};
    for (const Json* rows : {&part.results, &part.failures}) {
      for (const Json& row : *rows) {
        if (row.at("row").get<std::size_t>() >= part.rows) {
          throw InputError(file + ": is damaged; run its shard again");
        }
      }
    }
    return part;
  } catch (const Json::exception&) {
    throw InputError(file + ": is damaged; run its shard again");
  }
}

std::vector<NamedPart> readPartsOf(const std::string& directory) {
  std::error_code error;
  std::vector<NamedPart> parts;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory, error)) {
    const std::string name = entry.path().filename().string();
    if (const auto shard = shardOf(name)) {
      parts.push_back({name, *shard, readPart(directory + '/' + name)});
    }
  }
  if (parts.empty()) {
    throw InputError(directory +
                     ": holds no part, shard-I-of-N.json; run `sfw map --list` or `sfw bench` with "
                     "--shard, and bring the output of all machines into one directory");
  }
  std::sort(parts.begin(), parts.end(), [](const NamedPart& a, const NamedPart& b) {
    return std::tie(a.shard.count, a.shard.index) < std::tie(b.shard.count, b.shard.index);
  });
  return parts;
}

/// @throw InputError naming what differs between two parts
void requireSameWork(const NamedPart& first, const NamedPart& other) {
  if (first.shard.count != other.shard.count) {
    throw InputError(first.file + " and " + other.file +
                     " divide the list differently; remove the parts of one division");
  }
  Json works[] = {first.part.work, other.part.work};
  works[0]["number of rows"] = first.part.rows;
  works[1]["number of rows"] = other.part.rows;
  for (const auto& [key, value] : works[0].items()) {
    if (works[1].value(key, Json()) != value) {
      throw InputError(first.file + " and " + other.file + " differ in the " + key + ": " +
                       value.dump() + " and " + works[1].value(key, Json()).dump() +
                       "; run one of the two shards again as the others");
    }
  }
}

/// The file of each row, from 0; empty for a row that no part has. @throw InputError for rows that
/// two parts have.
std::vector<std::string> ownersOf(const std::vector<NamedPart>& parts) {
  std::vector<std::string> owners(parts.front().part.rows);
  for (const NamedPart& named : parts) {
    for (const Json* rows : {&named.part.results, &named.part.failures}) {
      for (const Json& row : *rows) {
        std::string& owner = owners[row.at("row").get<std::size_t>()];
        if (!owner.empty()) {
          throw InputError(owner + " and " + named.file + " both have row " +
                           std::to_string(row.at("row").get<std::size_t>() + 1) +
                           "; run the two shards again");
        }
        owner = named.file;
      }
    }
  }
  return owners;
}

/// @throw InputError naming the shards that are missing or lack rows
void requireAllRows(const std::vector<NamedPart>& parts) {
  const std::size_t count = parts.front().shard.count;
  const std::vector<std::string> owners = ownersOf(parts);
  std::map<std::size_t, std::size_t> missing;  // rows, by the index of the shard
  for (std::size_t row = 0; row < owners.size(); ++row) {
    if (owners[row].empty()) {
      ++missing[row % count];
    }
  }
  Problems problems;
  for (const auto& [index, rows] : missing) {
    problems.add("shard " + toText(Shard{index, count}) + " is missing, " + std::to_string(rows) +
                 " of " + std::to_string(owners.size()) + " rows; run it with --shard " +
                 toText(Shard{index, count}));
  }
  problems.throwIfAny();
}

void sortByRow(Json& rows) {
  std::sort(rows.begin(), rows.end(), [](const Json& a, const Json& b) {
    return a.at("row").get<std::size_t>() < b.at("row").get<std::size_t>();
  });
}

}  // namespace

Json workOf(const std::string& command) {
  return {{"command", command}, {"version", version()}, {"program", hexText(hashOfProgram())}};
}

void requireNone(const std::vector<std::string>& failures, std::size_t rows,
                 const std::string& outcome) {
  if (failures.empty()) {
    return;
  }
  std::string text = std::to_string(failures.size()) + " of " + std::to_string(rows) +
                     " recordings " + outcome + ":";
  for (const std::string& failure : failures) {
    text += "\n" + failure;
  }
  throw InputError(text);
}

void writePart(const Part& part, const Shard& shard, const std::string& directory) {
  const std::string file = directory + '/' + partNameOf(shard);
  const Json json{{"work", part.work},
                  {"rows", part.rows},
                  {"results", part.results},
                  {"failures", part.failures}};
  writeAtomically(file, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
  std::cerr << "sfw: wrote " << part.results.size() + part.failures.size() << " of " << part.rows
            << " rows to " << file << "; `sfw merge --output " << directory
            << "` puts all shards together\n";
}

Part mergedParts(const std::string& directory) {
  const std::vector<NamedPart> parts = readPartsOf(directory);
  for (const NamedPart& other : parts) {
    requireSameWork(parts.front(), other);
  }
  requireAllRows(parts);
  Part merged{parts.front().part.work, parts.front().part.rows};
  for (const NamedPart& named : parts) {
    merged.results.insert(merged.results.end(), named.part.results.begin(),
                          named.part.results.end());
    merged.failures.insert(merged.failures.end(), named.part.failures.begin(),
                           named.part.failures.end());
  }
  sortByRow(merged.results);
  sortByRow(merged.failures);
  return merged;
}

}  // namespace sfw
