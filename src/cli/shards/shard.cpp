#include "cli/shards/shard.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// A number in plain digits; 0 if it is none.
std::size_t numberIn(std::string_view text) {
  const char* const end = text.data() + text.size();
  std::size_t number = 0;
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && rest == end ? number : 0;
}

}  // namespace

std::vector<std::size_t> Shard::rowsOf(std::size_t all) const {
  std::vector<std::size_t> rows;
  for (std::size_t row = index; row < all; row += count) {
    rows.push_back(row);
  }
  return rows;
}

std::string toText(const Shard& shard) {
  return std::to_string(shard.index + 1) + '/' + std::to_string(shard.count);
}

std::string partNameOf(const Shard& shard) {
  return "shard-" + std::to_string(shard.index + 1) + "-of-" + std::to_string(shard.count) +
         ".json";
}

void addShard(Options& options, std::string& text) {
  options.add("shard", "I/N", text,
              "make only part I of N: the rows I, I + N, I + 2 N, ... `sfw merge` puts the parts "
              "together");
}

Shard shardOf(const Options& options, const std::string& text) {
  return options.given("shard") ? parseShard(text) : Shard{};
}

Shard parseShard(const std::string& text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const std::size_t number = numberIn(text.substr(0, slash));
  const std::size_t count = numberIn(text.substr(std::min(slash + 1, text.size())));
  if (number < 1 || number > count || count > kMostShards) {
    throw InputError("--shard must be I/N with whole numbers 1 <= I <= N <= " +
                     std::to_string(kMostShards) + ", such as 2/8; it is '" + text + "'");
  }
  return {number - 1, count};
}

}  // namespace sfw
