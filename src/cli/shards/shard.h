#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cli/options.h"

namespace sfw {

/// A part of a work list: the rows `index`, `index + count`, `index + 2 count`, ... The whole list
/// is the one shard of one.
struct Shard {
  std::size_t index = 0;  ///< from 0
  std::size_t count = 1;

  /// The rows of this shard in a list of so many rows, from 0.
  std::vector<std::size_t> rowsOf(std::size_t all) const;
};

constexpr std::size_t kMostShards = 1000000;

/// "2/8", counted from 1.
std::string toText(const Shard& shard);

/// "shard-2-of-8.json", the part file of a shard.
std::string partNameOf(const Shard& shard);

/// Declares --shard, whose text shardOf reads.
void addShard(Options& options, std::string& text);

/// The shard that parsed options give; the whole list if they give none.
/// @throw as parseShard
Shard shardOf(const Options& options, const std::string& text);

/// Reads the value of --shard.
/// @throw InputError unless it is I/N with 1 <= I <= N <= kMostShards
Shard parseShard(const std::string& text);

}  // namespace sfw
