// Measures the CPU time of reading a CSV of readings, and of the grids of a map. References in the
// same run are a plain loop of std::from_chars (std::strtod where the standard library lacks it)
// over the same fields, and a plain look-up in a table of the 256 values that a cell can have.
//
// Usage: files_benchmark
// The CSV has a million readings, and the grids 1000 x 1000 cells. Both parts of a pair run in
// turns.

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "comparison.h"
#include "files/text.h"
#include "ros/conversion/message_conversion.h"
#include "structure_from_wifi/belief_map.h"
#include "structure_from_wifi/readings_io.h"

namespace sfw {
namespace {

constexpr std::size_t kReadings = 1000000;
constexpr std::int64_t kSide = 1000;

std::vector<Reading> manyReadings() {
  std::mt19937 random(5);
  std::vector<Reading> readings;
  for (std::size_t i = 0; i < kReadings; ++i) {
    const auto number = [&](int range) { return static_cast<int>(random() % 1000000) % range; };
    readings.push_back({static_cast<std::int64_t>(i) * 10000000,
                        {1e-4 * number(400000), 1e-4 * number(400000)},
                        *Bssid::parse("02:00:00:00:00:01"),
                        -30.0 - 0.01 * number(6000)});
  }
  return readings;
}

/// Reads a number and the separator behind it.
double nextNumber(const char*& at, [[maybe_unused]] const char* end) {
#ifdef __cpp_lib_to_chars
  double value = 0.0;
  at = std::from_chars(at, end, value).ptr + 1;
  return value;
#else
  char* behind = nullptr;
  const double value = std::strtod(at, &behind);
  at = behind + 1;
  return value;
#endif
}

/// Sums the numbers of a table of readings, without checking anything.
double plainSum(const std::string& file) {
  const std::string text = readFile(file);
  const char* at = text.data() + text.find('\n') + 1;
  const char* const end = text.data() + text.size();
  double sum = 0.0;
  while (at < end) {
    for (int field = 0; field < 3; ++field) {
      sum += nextNumber(at, end);
    }
    std::uint64_t bssid = 0;
    for (int octet = 0; octet < 6; ++octet) {
      unsigned byte = 0;
      at = std::from_chars(at, end, byte, 16).ptr + 1;
      bssid = bssid << 8 | byte;
    }
    sum += nextNumber(at, end) + static_cast<double>(bssid & 1U);
  }
  return sum;
}

/// The table of readings in a temporary file.
class ReadingsFile {
 public:
  ReadingsFile()
      : name_((std::filesystem::temp_directory_path() / "sfw_files_benchmark.csv").string()) {
    std::ofstream(name_) << readingsCsv(manyReadings());
  }
  ReadingsFile(const ReadingsFile&) = delete;
  ReadingsFile& operator=(const ReadingsFile&) = delete;
  ~ReadingsFile() { std::remove(name_.c_str()); }

  const std::string& name() const { return name_; }

 private:
  std::string name_;
};

Pair reading() {
  const auto file = std::make_shared<const ReadingsFile>();
  return {kReadings, [=] { return readReadings(file->name()).readings.back().rssi_dbm; },
          [=] { return plainSum(file->name()); }};
}

/// A map, and as many values that a table of 256 entries turns into a grid.
struct Grids {
  BeliefMap belief;
  std::vector<std::uint8_t> values;
  std::vector<std::int8_t> table = std::vector<std::int8_t>(256);
};

Grids randomGrids() {
  Grid<float> occupied(GridGeometry(0.05, {0.0, 0.0}, kSide, kSide));
  std::mt19937 random(6);
  std::vector<std::uint8_t> values;
  for (float& p : occupied.cells) {
    p = static_cast<float>(random() % 1001) / 1000.0F;
    values.push_back(static_cast<std::uint8_t>(random()));
  }
  return {BeliefMap(occupied, {}), values};
}

/// @param convert  turns a map into a message
template <class Convert>
Pair grids(Convert convert) {
  const auto made = std::make_shared<const Grids>(randomGrids());
  return {made->values.size(),
          [=] { return static_cast<double>(convert(made->belief).data.back()); },
          [=] {
            std::vector<std::int8_t> data(made->values.size());
            for (std::size_t i = 0; i < data.size(); ++i) {
              data[i] = made->table[made->values[i]];
            }
            return static_cast<double>(data.back());
          }};
}

}  // namespace
}  // namespace sfw

int main(int count, char** arguments) {
  return sfw::runBenchmarks(count, arguments, [](const auto& /*none*/) {
    sfw::declareComparison("CSV of readings/from_chars", sfw::reading);
    sfw::declareComparison("trinary grid/look-up", [] {
      return sfw::grids([](const sfw::BeliefMap& map) { return toTrinaryGrid(map, {}); });
    });
    sfw::declareComparison("probability grid/look-up", [] {
      return sfw::grids([](const sfw::BeliefMap& map) { return toProbabilityGrid(map, {}); });
    });
  });
}
