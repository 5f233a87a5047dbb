#include "cli/bench/bench_store.h"

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/hash.h"
#include "files/atomic_file.h"
#include "files/text.h"

namespace sfw {
namespace {

namespace fs = std::filesystem;

constexpr char kEnding[] = ".json";

template <class T>
std::string bytesOf(const T* data, std::size_t count) {
  return {reinterpret_cast<const char*>(data), count * sizeof(T)};
}

}  // namespace

std::uint64_t hashOf(const FloorPlan& plan) {
  const GridGeometry& g = plan.geometry;
  const std::array<double, 3> lengths{g.resolution(), g.origin().x(), g.origin().y()};
  const std::array<std::int64_t, 2> sizes{g.width(), g.height()};
  const std::uint64_t of_geometry =
      hashOf(bytesOf(sizes.data(), sizes.size()), hashOf(bytesOf(lengths.data(), lengths.size())));
  return hashOf(bytesOf(plan.cells.data(), plan.cells.size()), of_geometry);
}

BenchStore::BenchStore(const std::string& directory) : directory_(directory) {
  makeDirectories(directory);
}

void BenchStore::removeUnfinished() const {
  for (const fs::directory_entry& entry : fs::directory_iterator(directory_)) {
    if (entry.path().extension() != kEnding &&
        entry.path().stem().extension() == kEnding) {  // 0123.json.XXXXXX
      fs::remove(entry.path());
    }
  }
}

std::string BenchStore::fileOf(const std::string& key) const {
  return directory_ + '/' + hexText(hashOf(key)) + kEnding;
}

std::optional<std::string> BenchStore::find(const std::string& key) const {
  const std::string file = fileOf(key);
  if (!fs::is_regular_file(file)) {
    return std::nullopt;
  }
  const nlohmann::json stored = nlohmann::json::parse(readFile(file), nullptr, false);
  if (!stored.is_object() || !stored.contains("key") || stored["key"] != key ||
      !stored.contains("result") || !stored["result"].is_string()) {
    return std::nullopt;
  }
  return stored["result"].get<std::string>();
}

void BenchStore::save(const std::string& key, const std::string& result) const {
  nlohmann::json stored{{"key", key}, {"result", result}};
  writeAtomically(fileOf(key), stored.dump(1) + "\n");
}

}  // namespace sfw
