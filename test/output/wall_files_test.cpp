#include "output/wall_files.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>
#include <utility>

#include "files/text.h"
#include "structure_from_wifi/map_files.h"
#include "support/ascii_world.h"
#include "support/complaint.h"
#include "support/temporary_folder.h"

namespace sfw {
namespace {

using Rows = std::vector<std::string>;
using WallFiles = test::TemporaryFolder;

const std::vector<WallSegment> kWalls{{{-0.75, 1.6}, {-0.75, 1.9}, 0.625},
                                      {{-0.6004, 1.72}, {-0.3, 1.72}, 0.9},
                                      {{-0.75, 2.0}, {-0.05, 2.0}, 0.75, true}};

/// Two free rooms, one around a pillar.
const Rows kPicture{".....?..",  //
                    ".#...?..",  //
                    ".....?..",  //
                    ".....?.."};

Snapshot snapshotOf(const Rows& rows, const std::vector<WallSegment>& walls) {
  const auto probability = [](char c) { return c == '.' ? 0.1F : c == '#' ? 0.9F : 0.5F; };
  const Position origin(-0.8, 1.6);
  const BeliefMap belief(test::gridFrom<float>(rows, 0.1, probability, origin), {});
  Snapshot snapshot{belief, belief, {}, {}, {}};
  snapshot.walls = walls;
  return snapshot;
}

Snapshot snapshot() { return snapshotOf(kPicture, kWalls); }

/// All numbers that a pattern finds, one vector a match.
std::vector<std::vector<double>> numbersIn(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::vector<double>> all;
  for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match) {
    all.emplace_back();
    for (std::size_t i = 1; i < match->size(); ++i) {
      all.back().push_back(parseNumber((*match)[i].str()).value());
    }
  }
  return all;
}

// ---- YAML ----

TEST(WallsYaml, IsReadBack) {
  const YAML::Node yaml = YAML::Load(wallsYaml(kWalls));
  EXPECT_EQ(yaml["format"].as<int>(), 1);
  EXPECT_EQ(yaml["frame"].as<std::string>(), "map");
  EXPECT_EQ(yaml["unit"].as<std::string>(), "m");
  ASSERT_EQ(yaml["walls"].size(), kWalls.size());
  for (std::size_t i = 0; i < kWalls.size(); ++i) {
    const YAML::Node wall = yaml["walls"][i];
    for (const auto& [key, end] : {std::pair("from", kWalls[i].from), {"to", kWalls[i].to}}) {
      const auto point = wall[key].as<std::vector<double>>();
      ASSERT_EQ(point.size(), 2U);
      EXPECT_NEAR(point[0], end.x(), 0.0005);
      EXPECT_NEAR(point[1], end.y(), 0.0005);
    }
    EXPECT_NEAR(wall["confidence"].as<double>(), kWalls[i].confidence, 0.0005);
    EXPECT_EQ(wall["outer"].as<bool>(), kWalls[i].is_outer);
  }
}

TEST(WallsYaml, IsWrittenForPeopleToo) {
  EXPECT_NE(wallsYaml({{{-0.00001, 2.0}, {1.0 / 3.0, 2.0}, 0.5}})
                .find("  - {from: [0, 2], to: [0.333, 2], confidence: 0.5, outer: false}\n"),
            std::string::npos);
}

TEST(WallsYaml, HoldsAnEmptyListWithoutWalls) {
  const YAML::Node yaml = YAML::Load(wallsYaml({}));
  EXPECT_TRUE(yaml["walls"].IsSequence());
  EXPECT_EQ(yaml["walls"].size(), 0U);
}

// ---- Outlines ----

TEST(FloorDrawing, OutlinesFreeSpaceAndItsHolesByTheirCorners) {
  const FloorDrawing drawing = floorDrawing(snapshot());
  ASSERT_EQ(drawing.free_outlines.size(), 3U);
  const auto has = [&](const std::vector<Position>& corners) {
    return std::any_of(drawing.free_outlines.begin(), drawing.free_outlines.end(),
                       [&](const std::vector<Position>& outline) {
                         return outline.size() == corners.size() &&
                                std::all_of(corners.begin(), corners.end(), [&](const auto& a) {
                                  return std::any_of(
                                      outline.begin(), outline.end(),
                                      [&](const auto& b) { return (a - b).norm() < 1e-9; });
                                });
                       });
  };
  EXPECT_TRUE(has({{-0.75, 1.65}, {-0.35, 1.65}, {-0.35, 1.95}, {-0.75, 1.95}}));
  EXPECT_TRUE(has({{-0.15, 1.65}, {-0.05, 1.65}, {-0.05, 1.95}, {-0.15, 1.95}}));
  EXPECT_TRUE(has({{-0.75, 1.75}, {-0.55, 1.75}, {-0.55, 1.95}, {-0.75, 1.95}}));  // the pillar
}

TEST(FloorDrawing, CoversItsLinesAndWithoutAnyTheMap) {
  const FloorDrawing drawing = floorDrawing(snapshot());
  EXPECT_NEAR((drawing.area.min() - Position(-0.75, 1.6)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((drawing.area.max() - Position(-0.05, 2.0)).norm(), 0.0, 1e-9);
  const Snapshot unknown = snapshotOf({"??", "??"}, {});
  EXPECT_TRUE(floorDrawing(unknown).area.isApprox(unknown.belief.geometry().box()));
}

// ---- SVG ----

TEST(WallsSvg, HoldsWallsInMetresWithTheirConfidence) {
  const auto lines = numbersIn(
      wallsSvg(floorDrawing(snapshot())),
      R"re(<line x1="(\S+)" y1="(\S+)" x2="(\S+)" y2="(\S+)" stroke-opacity="(\S+)"/>)re");
  ASSERT_EQ(lines.size(), kWalls.size());
  for (std::size_t i = 0; i < kWalls.size(); ++i) {
    const WallSegment& wall = kWalls[i];
    const std::vector<double> expected{wall.from.x(), wall.from.y(), wall.to.x(), wall.to.y(),
                                       wall.confidence};
    for (std::size_t j = 0; j < expected.size(); ++j) {
      EXPECT_NEAR(lines[i][j], expected[j], 0.0005);
    }
  }
}

TEST(WallsSvg, OuterWallsAreDashedOnTheirOwnLayer) {
  const std::string svg = wallsSvg(floorDrawing(snapshot()));
  const std::size_t layer = svg.find("<g id=\"outer_walls\"");
  ASSERT_NE(layer, std::string::npos);
  const std::string walls = svg.substr(0, layer);
  const std::string outer_walls = svg.substr(layer);
  EXPECT_EQ(walls.find("dasharray"), std::string::npos);
  EXPECT_NE(outer_walls.find("stroke-dasharray"), std::string::npos);
  EXPECT_EQ(numbersIn(walls, R"re(<line x1="(\S+)")re").size(), 2U);
  EXPECT_EQ(numbersIn(outer_walls, R"re(<line x1="(\S+)")re").size(), 1U);
}

TEST(WallsSvg, ShowsTheMapUprightOnItsPage) {
  const FloorDrawing drawing = floorDrawing(snapshot());
  const std::string svg = wallsSvg(drawing);
  const auto page = numbersIn(svg, R"re(viewBox="0 0 (\S+) ([^"]+)")re").at(0);
  const auto layers = numbersIn(svg, R"re(matrix\((\S+) 0 0 (\S+) (\S+) ([^)]+)\))re");
  ASSERT_EQ(layers.size(), 3U);
  for (const std::vector<double>& layer : layers) {
    const auto on_page = [&](const Position& point) {
      return Position(layer[0] * point.x() + layer[2], layer[1] * point.y() + layer[3]);
    };
    const Position low = on_page(drawing.area.min());
    const Position high = on_page(drawing.area.max());
    EXPECT_NEAR(high.x() - low.x(), 20.0 * drawing.area.sizes().x(), 0.01);  // mm, 1:50
    EXPECT_NEAR(low.y() - high.y(), 20.0 * drawing.area.sizes().y(), 0.01);
    for (const Position& corner : {low, high}) {
      EXPECT_GT(corner.minCoeff(), 0.0);
      EXPECT_LT(corner.x(), page[0]);
      EXPECT_LT(corner.y(), page[1]);
    }
  }
}

TEST(WallsSvg, ClosesEveryElement) {
  for (const Snapshot& one : {snapshot(), snapshotOf({"??", "??"}, {})}) {
    const std::string svg = wallsSvg(floorDrawing(one));
    std::vector<std::string> open;
    const std::regex tag(R"re(<(/?)([a-z]+)[^>]*?(/?)>)re");
    for (std::sregex_iterator match(svg.begin(), svg.end(), tag), end; match != end; ++match) {
      if ((*match)[1] == "/") {
        ASSERT_FALSE(open.empty());
        EXPECT_EQ(open.back(), (*match)[2]);
        open.pop_back();
      } else if ((*match)[3] != "/") {
        open.push_back((*match)[2]);
      }
    }
    EXPECT_TRUE(open.empty());
  }
}

// ---- DXF ----

using Pairs = std::vector<std::pair<int, std::string>>;

Pairs pairsOf(const std::string& dxf) {
  Pairs pairs;
  std::istringstream lines(dxf);
  std::string code, value;
  while (std::getline(lines, code) && std::getline(lines, value)) {
    pairs.emplace_back(std::stoi(code), value);
  }
  return pairs;
}

/// The pairs of each entity of a type: from its name to the next code 0.
std::vector<Pairs> entities(const Pairs& pairs, const std::string& type) {
  std::vector<Pairs> found;
  bool inside = false;
  for (const auto& pair : pairs) {
    if (pair.first == 0) {
      inside = pair.second == type;
      if (inside) {
        found.emplace_back();
      }
    }
    if (inside) {
      found.back().push_back(pair);
    }
  }
  return found;
}

std::string valueOf(const Pairs& pairs, int code) {
  const auto found = std::find_if(pairs.begin(), pairs.end(),
                                  [&](const auto& pair) { return pair.first == code; });
  return found == pairs.end() ? "" : found->second;
}

double numberOf(const Pairs& pairs, int code) {
  return parseNumber(valueOf(pairs, code)).value_or(std::nan(""));
}

TEST(WallsDxf, HoldsALineForEachWallOnItsLayer) {
  const auto lines = entities(pairsOf(wallsDxf(floorDrawing(snapshot()))), "LINE");
  ASSERT_EQ(lines.size(), kWalls.size());
  for (std::size_t i = 0; i < kWalls.size(); ++i) {
    EXPECT_EQ(valueOf(lines[i], 8), kWalls[i].is_outer ? "OUTER_WALLS" : "WALLS");
    EXPECT_NEAR(numberOf(lines[i], 10), kWalls[i].from.x(), 0.0005);
    EXPECT_NEAR(numberOf(lines[i], 20), kWalls[i].from.y(), 0.0005);
    EXPECT_EQ(numberOf(lines[i], 30), 0.0);
    EXPECT_NEAR(numberOf(lines[i], 11), kWalls[i].to.x(), 0.0005);
    EXPECT_NEAR(numberOf(lines[i], 21), kWalls[i].to.y(), 0.0005);
    EXPECT_EQ(numberOf(lines[i], 31), 0.0);
  }
}

TEST(WallsDxf, OutlinesFreeSpaceByClosedPolylines) {
  const FloorDrawing drawing = floorDrawing(snapshot());
  const Pairs pairs = pairsOf(wallsDxf(drawing));
  std::size_t corners = 0;
  for (const std::vector<Position>& outline : drawing.free_outlines) {
    corners += outline.size();
  }
  const auto polylines = entities(pairs, "POLYLINE");
  EXPECT_EQ(polylines.size(), drawing.free_outlines.size());
  EXPECT_EQ(entities(pairs, "SEQEND").size(), polylines.size());
  EXPECT_EQ(entities(pairs, "VERTEX").size(), corners);
  for (const Pairs& polyline : polylines) {
    EXPECT_EQ(valueOf(polyline, 8), "FREE");
    EXPECT_EQ(valueOf(polyline, 66), "1");  // vertices follow
    EXPECT_EQ(valueOf(polyline, 70), "1");  // closed
  }
}

TEST(WallsDxf, IsR12InMetresWithItsLayers) {
  const Pairs pairs = pairsOf(wallsDxf(floorDrawing(snapshot())));
  const auto after = [&](const std::string& variable) {
    const auto name = std::find(pairs.begin(), pairs.end(), std::pair(9, variable));
    return name == pairs.end() ? std::string() : (name + 1)->second;
  };
  EXPECT_EQ(after("$ACADVER"), "AC1009");
  EXPECT_EQ(after("$INSUNITS"), "6");
  std::vector<std::string> layers;
  for (const Pairs& layer : entities(pairs, "LAYER")) {
    layers.push_back(valueOf(layer, 2));
  }
  EXPECT_EQ(layers, (std::vector<std::string>{"WALLS", "OUTER_WALLS", "FREE"}));
  EXPECT_EQ(entities(pairs, "SECTION").size(), entities(pairs, "ENDSEC").size());
  EXPECT_EQ(entities(pairs, "TABLE").size(), entities(pairs, "ENDTAB").size());
  EXPECT_EQ(pairs.back(), std::pair(0, std::string("EOF")));
}

// ---- Directory ----

TEST_F(WallFiles, OfAMapWithoutWallsReplaceThoseOfAnEarlierMap) {
  writeMapFiles(snapshot(), Config(), folder_.string());
  EXPECT_EQ(YAML::LoadFile(path("walls.yaml"))["walls"].size(), kWalls.size());
  writeMapFiles(snapshotOf(kPicture, {}), Config(), folder_.string());
  EXPECT_EQ(YAML::LoadFile(path("walls.yaml"))["walls"].size(), 0U);
  EXPECT_EQ(read("walls.svg").find("<line"), std::string::npos);
  EXPECT_TRUE(entities(pairsOf(read("walls.dxf")), "LINE").empty());
}

TEST_F(WallFiles, AreReadBack) {
  const std::vector<WallSegment> walls = readWalls(write("walls.yaml", wallsYaml(kWalls)));
  ASSERT_EQ(walls.size(), kWalls.size());
  for (std::size_t i = 0; i < walls.size(); ++i) {
    EXPECT_LT((walls[i].from - kWalls[i].from).norm(), 1e-3);
    EXPECT_LT((walls[i].to - kWalls[i].to).norm(), 1e-3);
    EXPECT_NEAR(walls[i].confidence, kWalls[i].confidence, 1e-3);
    EXPECT_EQ(walls[i].is_outer, kWalls[i].is_outer);
  }
}

TEST_F(WallFiles, HoldWallsThatAreNearlySure) {
  std::vector<WallSegment> sure = kWalls;
  sure[0].confidence = 0.99996;
  sure[1].confidence = 0.00001;
  for (const WallSegment& wall : readWalls(write("walls.yaml", wallsYaml(sure)))) {
    EXPECT_GT(wall.confidence, 0.0);
    EXPECT_LT(wall.confidence, 1.0);
  }
}

TEST_F(WallFiles, NameAWallThatCannotBeUsed) {
  const std::string file = write(
      "walls.yaml", "walls:\n  - {from: [0, 0], to: [1, 0], confidence: 1.5, outer: false}\n");
  const std::string text = test::complaintOf([&] { readWalls(file); });
  EXPECT_NE(text.find("wall 1"), std::string::npos) << text;
  EXPECT_NE(text.find("walls.yaml"), std::string::npos) << text;
}

}  // namespace
}  // namespace sfw
