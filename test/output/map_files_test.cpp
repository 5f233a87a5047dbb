#include "structure_from_wifi/map_files.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "files/map_server.h"
#include "files/png.h"
#include "output/report.h"
#include "structure_from_wifi/access_points_io.h"
#include "structure_from_wifi/mapper.h"
#include "structure_from_wifi/readings_io.h"
#include "support/ascii_world.h"
#include "support/temporary_folder.h"

namespace sfw {
namespace {

using Rows = std::vector<std::string>;
using MapFiles = test::TemporaryFolder;

const Rows kPicture{".#?..",  //
                    "#???.",  //
                    "...##"};

/// The belief that a picture shows.
BeliefMap beliefOf(const Rows& rows, double resolution = 0.1,
                   const Position& origin = Position(-0.8, 1.6)) {
  const auto probability = [](char c) { return c == '.' ? 0.1F : c == '#' ? 0.9F : 0.5F; };
  return {test::gridFrom<float>(rows, resolution, probability, origin), Config::Belief()};
}

AccessPointSummary summaryOf(const std::string& bssid, const std::string& name, double x,
                             double y) {
  AccessPoint access_point;
  access_point.bssid = *Bssid::parse(bssid);
  access_point.name = name;
  access_point.position = {x, y};
  return {access_point, 3, WallCountClusters{{-45.0, -60.0}, {-52.5}}};
}

Snapshot snapshotOf(const Rows& rows) {
  const Bssid stranger = *Bssid::parse("0a:00:00:00:00:09");
  return {beliefOf(rows),
          beliefOf(rows),
          {{1000000000, {-0.7, 1.7}, 0}, {2000000000, {-0.4, 1.7}, 1}},
          {summaryOf("02:00:00:00:00:01", "router", -0.75, 1.85)},
          {{{InsertResult::kRssiNotFinite, 4}}, {{stranger, 2}}}};
}

// ---- Rasters ----

TEST(Rasters, HoldTheTopRowFirst) {
  const std::string pixels{
      "\xfe\x00\xcd\xfe\xfe"
      "\x00\xcd\xcd\xcd\xfe"
      "\xfe\xfe\xfe\x00\x00",
      15};
  EXPECT_EQ(trinaryPgm(beliefOf(kPicture)), "P5\n5 3\n255\n" + pixels);
}

TEST(Rasters, HoldProbabilitiesInTheirOwnFile) {
  const BeliefMap belief = beliefOf({"#?."});
  const std::string pgm = probabilityPgm(belief);
  const std::string header = "P5\n3 1\n255\n";
  ASSERT_EQ(pgm.substr(0, header.size()), header);
  const auto pixel = [&](std::size_t i) {
    return static_cast<int>(static_cast<unsigned char>(pgm[header.size() + i]));
  };
  EXPECT_NEAR(pixel(0), 255 * 0.1, 2.0);
  EXPECT_EQ(pixel(1), 128);
  EXPECT_NEAR(pixel(2), 255 * 0.9, 2.0);
}

TEST_F(MapFiles, AreReadBackAsTheyWere) {
  writeMapFiles(snapshotOf(kPicture), Config(), folder_.string());
  const Grid<CellState> map = readMap(path("map.yaml"));
  EXPECT_EQ(test::rowsOf(map), kPicture);
  EXPECT_EQ(map.geometry, GridGeometry(0.1, {-0.8, 1.6}, 5, 3));
}

TEST_F(MapFiles, KeepTheirGeometryToTheLastDigitThatMatters) {
  for (const double resolution : {0.05, 0.03, 0.025, 1.0 / 3.0}) {
    const Position origin(-271.0 * resolution, 1000.0 * resolution);
    const BeliefMap belief = beliefOf(kPicture, resolution, origin);
    write("map.pgm", trinaryPgm(belief));
    const GridGeometry read_back =
        readMap(write("map.yaml", trinaryYaml(belief.geometry()))).geometry;
    EXPECT_NEAR(read_back.resolution(), resolution, 1e-9);
    EXPECT_NEAR((read_back.origin() - origin).norm(), 0.0, 1e-6);
  }
}

TEST_F(MapFiles, KeepProbabilitiesToAStepOfTheirRaster) {
  Grid<float> occupied(GridGeometry(0.1, {0, 0}, 64, 16));
  std::mt19937 random(4);
  for (float& p : occupied.cells) {
    p = static_cast<float>(random() % 1001) / 1000.0F;
  }
  const BeliefMap belief(occupied, {});
  write("probability.png", probabilityPng(belief));
  const Grid<float> read_back =
      readProbabilities(write("probability.yaml", probabilityYaml(belief.geometry())));
  for (std::int64_t y = 0; y < 16; ++y) {
    for (std::int64_t x = 0; x < 64; ++x) {
      ASSERT_NEAR((read_back[{x, y}]), belief.occupied({x, y}), 0.5 / 255.0 + 1e-6);
    }
  }
}

TEST_F(MapFiles, KeepUnknownProbabilitiesTransparent) {
  const BeliefMap belief = beliefOf({"#?.", "..?"});
  write("probability.png", probabilityPng(belief));
  const TranslucentImage image = readPng(path("probability.png"));
  EXPECT_EQ(image.opacity, (std::vector<std::uint8_t>{255, 0, 255, 255, 255, 0}));
  const Grid<float> read_back =
      readProbabilities(write("probability.yaml", probabilityYaml(belief.geometry())));
  EXPECT_EQ((read_back[{1, 1}]), 0.5F);
  EXPECT_NEAR((read_back[{0, 1}]), 0.9, 0.01);
  EXPECT_NEAR((read_back[{2, 1}]), 0.1, 0.01);
}

TEST_F(MapFiles, HoldCostsForPlanners) {
  writeMapFiles(snapshotOf(kPicture), Config(), folder_.string());
  const TranslucentImage image = readPng(path("costs.png"));
  constexpr std::uint8_t kDear = 3;  // all free cells lie near a wall: 1 % of 255
  constexpr std::uint8_t kUnknown = 128;
  EXPECT_EQ(image.grey.pixels,
            (std::vector<std::uint8_t>{kDear, 0, kUnknown, kDear, kDear,        //
                                       0, kUnknown, kUnknown, kUnknown, kDear,  //
                                       kDear, kDear, kDear, 0, 0}));
  for (std::size_t i = 0; i < image.opacity.size(); ++i) {
    EXPECT_EQ(image.opacity[i], image.grey.pixels[i] == kUnknown ? 0 : 255) << i;
  }
  const Grid<float> read_back = readProbabilities(path("costs.yaml"));
  EXPECT_NEAR((read_back[{0, 0}]), 0.99, 0.005);
  EXPECT_EQ((read_back[{1, 2}]), 1.0F);
}

// ---- Tables ----

TEST_F(MapFiles, ReadingsAreReadBackBitByBit) {
  std::vector<AccessPoint> table{summaryOf("02:00:00:00:00:01", "", 0, 0).access_point};
  Mapper mapper(Config(), table);
  std::mt19937 random(12);
  std::uniform_real_distribution<double> coordinate(-50.0, 50.0);
  std::uniform_real_distribution<double> rssi(-119.0, 0.0);
  for (const std::int64_t stamp_ns :
       {std::int64_t{1700000000123456789}, std::int64_t{0}, std::int64_t{1}, std::int64_t{-1},
        std::int64_t{-1500000000}, std::int64_t{-999999999}, std::int64_t{-3000000000000000001}}) {
    for (int i = 0; i < 50; ++i) {
      mapper.insert({stamp_ns + 1000 * i,
                     {coordinate(random), coordinate(random)},
                     table[0].bssid,
                     rssi(random)});
    }
  }
  const std::vector<Reading> readings = mapper.readings();
  const auto read_back = readReadings(write("readings.csv", readingsCsv(readings))).readings;
  ASSERT_EQ(read_back.size(), readings.size());
  for (std::size_t i = 0; i < readings.size(); ++i) {
    EXPECT_EQ(read_back[i].stamp_ns, readings[i].stamp_ns);
    EXPECT_EQ(read_back[i].antenna_in_map, readings[i].antenna_in_map);
    EXPECT_EQ(read_back[i].bssid, readings[i].bssid);
    EXPECT_EQ(read_back[i].rssi_dbm, readings[i].rssi_dbm);
  }
}

TEST_F(MapFiles, AccessPointsAreReadBack) {
  std::vector<AccessPoint> table{
      summaryOf("02:00:00:00:00:01", "caf\xc3\xa9 \"one\": {a, b} # \\n", 1.0 / 3.0, -1e-7)
          .access_point,
      summaryOf("02:00:00:00:00:02", "", 1e5, 2.0).access_point};
  table[0].height_m = 2.2;
  table[0].tx_dbm = -3.5;
  const auto read_back =
      readAccessPoints(write("table.yaml", accessPointsYaml(table))).access_points;
  ASSERT_EQ(read_back.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read_back[i].bssid, table[i].bssid);
    EXPECT_EQ(read_back[i].name, table[i].name);
    EXPECT_EQ(read_back[i].position, table[i].position);
    EXPECT_EQ(read_back[i].height_m, table[i].height_m);
    EXPECT_EQ(read_back[i].tx_dbm, table[i].tx_dbm);
  }
}

TEST_F(MapFiles, AccessPointsAreWrittenForPeopleToo) {
  const std::string text =
      accessPointsYaml({summaryOf("02:00:00:00:00:01", "router", 9.775, -0.1).access_point});
  EXPECT_NE(text.find("x: 9.775, y: -0.1}"), std::string::npos) << text;
}

TEST_F(MapFiles, ARecordingIsReadBack) {
  const Reading reading{5, {1.0, 2.0}, *Bssid::parse("02:00:00:00:00:01"), -40.0};
  const Contact contact{-1500000000, {0.25, -3.0}};
  writeRecording({reading}, {contact}, snapshotOf(kPicture), path("a/b"),
                 {{1500000000, {0.5, 0.75}}});
  EXPECT_EQ(readReadings(path("a/b/readings.csv")).readings.size(), 1U);
  const auto contacts = readContacts(path("a/b/contacts.csv"));
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].stamp_ns, contact.stamp_ns);
  EXPECT_EQ(contacts[0].point_in_map, contact.point_in_map);
  const auto poses = readPath(path("a/b/path.csv"));
  ASSERT_EQ(poses.size(), 1U);
  EXPECT_EQ(poses[0].stamp_ns, 1500000000);
  EXPECT_EQ(poses[0].antenna_in_map, Position(0.5, 0.75));
  EXPECT_EQ(readAccessPoints(path("a/b/access_points.yaml")).access_points.front().name, "router");
}

// ---- Report ----

TEST(Report, SaysWhatTheMapIsMadeOf) {
  const auto report = nlohmann::json::parse(reportJson(snapshotOf(kPicture), Config()));
  EXPECT_EQ(report["map"]["width"], 5);
  EXPECT_EQ(report["map"]["height"], 3);
  EXPECT_NEAR(report["map"]["free_m2"].get<double>(), 7 * 0.01, 1e-9);
  EXPECT_NEAR(report["map"]["occupied_m2"].get<double>(), 4 * 0.01, 1e-9);
  EXPECT_EQ(report["path"]["poses"], 2);
  EXPECT_NEAR(report["path"]["length_m"].get<double>(), 0.3, 1e-9);
  EXPECT_EQ(report["access_points"][0]["bssid"], "02:00:00:00:00:01");
  EXPECT_EQ(report["access_points"][0]["walls"], 1);
  EXPECT_EQ(report["access_points"][0]["thresholds_dbm"].size(), 1U);
  EXPECT_EQ(report["left_out"]["by_reason"]["rssi_dbm is not finite"], 4);
  EXPECT_EQ(report["left_out"]["unknown_access_points"]["0a:00:00:00:00:09"], 2);
  std::size_t settings = 0;
  const Config config;
  forEachSetting(config, [&](const std::string& name, const auto& value) {
    const std::size_t slash = name.find('/');
    if (slash == std::string::npos) {
      EXPECT_EQ(report["settings"][name], value);
    } else if (name.substr(0, slash) != "ros") {
      EXPECT_EQ(report["settings"][name.substr(0, slash)][name.substr(slash + 1)], value);
      ++settings;
    }
  });
  EXPECT_GT(settings, 10U);
}

TEST(Report, Repeats) {
  EXPECT_EQ(reportJson(snapshotOf(kPicture), Config()), reportJson(snapshotOf(kPicture), Config()));
}

TEST(Report, TakesNamesThatAreNoUtf8) {
  Snapshot snapshot = snapshotOf(kPicture);
  snapshot.access_points[0].access_point.name = "caf\xe9";
  const auto report = nlohmann::json::parse(reportJson(snapshot, Config()));
  EXPECT_EQ(report["access_points"][0]["name"], "caf\xef\xbf\xbd");
}

}  // namespace
}  // namespace sfw
