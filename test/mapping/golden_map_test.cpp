#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "files/pgm.h"
#include "support/mapper_scene.h"

// One map of the default method, cell by cell. Floating point differs between machines in its last
// bits, so a few cells near a threshold may differ; a changed method changes many more.

namespace sfw::test {
namespace {

const char* const kGolden = SFW_SOURCE_DIR "/test/data/golden_tomography.pgm";

/// Two rooms of 4 m x 3 m with a door between them, driven around 0.4 m from the walls.
std::vector<Position> wayThroughTwoRooms() {
  const std::vector<Position> corners{{0.4, 0.4}, {0.4, 2.6}, {3.6, 2.6}, {3.6, 1.5}, {4.4, 1.5},
                                      {4.4, 2.6}, {7.6, 2.6}, {7.6, 0.4}, {4.4, 0.4}, {4.4, 1.5},
                                      {3.6, 1.5}, {3.6, 0.4}, {0.5, 0.4}};
  std::vector<Position> way;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const Position leg = corners[i + 1] - corners[i];
    const auto steps = std::lround(leg.norm() / 0.1);
    for (std::int64_t step = 0; step < steps; ++step) {
      way.push_back(corners[i] + leg * (static_cast<double>(step) / static_cast<double>(steps)));
    }
  }
  return way;
}

/// Whether the wall at x = 4 m stands between two points: beside the door.
bool isBehindWall(const Position& a, const Position& b) {
  if ((a.x() < 4.0) == (b.x() < 4.0)) {
    return false;
  }
  const double y = a.y() + (b.y() - a.y()) * (4.0 - a.x()) / (b.x() - a.x());
  return std::abs(y - 1.5) > 0.4;
}

Mapper mapperOfTwoRooms() {
  Config config;
  config.map.resolution_m = 0.1;
  const std::vector<AccessPoint> access_points{accessPoint(1, 0.8, 0.9), accessPoint(2, 7.1, 2.2)};
  Mapper mapper(config, access_points);
  std::int64_t stamp_s = 0;
  for (const Position& place : wayThroughTwoRooms()) {
    ++stamp_s;
    for (int i = 0; i < 2; ++i) {
      const Position& from = access_points[static_cast<std::size_t>(i)].position;
      const double path_loss_db = 20.0 * std::log10(std::max((place - from).norm(), 0.3));
      const double wall_db = isBehindWall(from, place) ? 8.0 : 0.0;
      const auto ripple_db = static_cast<double>((stamp_s * 7 + i * 3) % 5 - 2);  // whole numbers
      mapper.insert(reading(stamp_s, place.x(), place.y(),
                            std::round(-40.0 - path_loss_db - wall_db + ripple_db), i + 1));
    }
  }
  return mapper;
}

TEST(GoldenMap, OfTheDefaultMethodIsAsItWas) {
  const auto snapshot = mapperOfTwoRooms().infer();
  ASSERT_NE(snapshot, nullptr);
  const std::filesystem::path made =
      std::filesystem::path(::testing::TempDir()) / "golden_tomography.pgm";
  std::ofstream(made, std::ios::binary) << trinaryPgm(snapshot->belief);
  const GreyImage map = readPgm(made.string());
  const GreyImage golden = readPgm(kGolden);
  ASSERT_EQ(map.width, golden.width);
  ASSERT_EQ(map.height, golden.height);
  constexpr int kUnknown = 205;
  double known = 0.0;
  double different = 0.0;
  for (std::size_t i = 0; i < map.pixels.size(); ++i) {
    known += map.pixels[i] != kUnknown || golden.pixels[i] != kUnknown ? 1.0 : 0.0;
    different += map.pixels[i] != golden.pixels[i] ? 1.0 : 0.0;
  }
  EXPECT_GT(known, 2000.0);
  EXPECT_LE(different, 0.001 * known)
      << "If a change of the method is meant to change maps, copy " << made << " to " << kGolden
      << " and say so in the change log.";
  if (!HasFailure()) {
    std::filesystem::remove(made);
  }
}

}  // namespace
}  // namespace sfw::test
