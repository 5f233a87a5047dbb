#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/shards/shard.h"

namespace sfw {

/// What all shards of a work list have in common: {"command", "version", "program", ...}, texts.
nlohmann::json workOf(const std::string& command);

/// The results of some rows of a work list. Each result and each failure has the key "row", from 0.
struct Part {
  nlohmann::json work;
  std::size_t rows = 0;  ///< of the whole list
  nlohmann::json results = nlohmann::json::array();
  nlohmann::json failures = nlohmann::json::array();  ///< each with the key "reason"
};

/// @throw InputError naming each failure and how many of the rows failed, if there is any
/// @param failures  one line each
/// @param rows      with and without a failure
/// @param outcome   of the failures, in words: "failed"
void requireNone(const std::vector<std::string>& failures, std::size_t rows,
                 const std::string& outcome);

/// Writes the part file of a shard, and says on standard error what it holds.
/// @throw std::system_error naming the file and why
void writePart(const Part& part, const Shard& shard, const std::string& directory);

/// Reads all part files of a directory and puts them together, in the order of the list.
/// @throw InputError if parts are missing, damaged, or not of one work list, settings and program
Part mergedParts(const std::string& directory);

}  // namespace sfw
