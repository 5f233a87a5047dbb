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
#include <exception>
#include <filesystem>
#include <fstream>
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

void compareReading() {
  const std::string file =
      (std::filesystem::temp_directory_path() / "sfw_files_benchmark.csv").string();
  std::ofstream(file) << readingsCsv(manyReadings());
  compare(
      "CSV of readings, from_chars", kReadings,
      [&] { return readReadings(file).readings.back().rssi_dbm; }, [&] { return plainSum(file); });
  std::filesystem::remove(file);
}

void compareGrids() {
  Grid<float> occupied(GridGeometry(0.05, {0.0, 0.0}, kSide, kSide));
  std::mt19937 random(6);
  std::vector<std::uint8_t> values;
  for (float& p : occupied.cells) {
    p = static_cast<float>(random() % 1001) / 1000.0F;
    values.push_back(static_cast<std::uint8_t>(random()));
  }
  const BeliefMap belief(occupied, {});
  std::vector<std::int8_t> table(256);
  const auto plain = [&] {
    std::vector<std::int8_t> data(values.size());
    for (std::size_t i = 0; i < data.size(); ++i) {
      data[i] = table[values[i]];
    }
    return static_cast<double>(data.back());
  };
  compare(
      "trinary grid, look-up", values.size(),
      [&] { return static_cast<double>(toTrinaryGrid(belief, {}).data.back()); }, plain);
  compare(
      "probability grid, look-up", values.size(),
      [&] { return static_cast<double>(toProbabilityGrid(belief, {}).data.back()); }, plain);
}

}  // namespace
}  // namespace sfw

int main() {
  try {
    std::puts(
        "| part, reference | items | own [ms] | reference [ms] | ratio | median | least |\n"
        "|---|---|---|---|---|---|---|");
    sfw::compareReading();
    sfw::compareGrids();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "files_benchmark: %s\n", error.what());
    return 1;
  }
  return 0;
}
