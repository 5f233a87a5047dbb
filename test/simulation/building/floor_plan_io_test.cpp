#include "simulation/building/floor_plan_io.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "support/ascii_world.h"
#include "support/floor_plan_files.h"
#include "support/floor_plans.h"

namespace sfw {
namespace {

using Rows = std::vector<std::string>;

class FloorPlanIo : public test::FloorPlanFiles {
 protected:
  std::string house(const std::string& vertices) const {
    return write("house.json", R"({"id": "1", "room_num": 2, "verts": )" + vertices + "}");
  }
};

/// 'O' outer wall, 'I' interior wall; without the margin of unknown cells.
Rows pictureOf(const FloorPlan& plan) {
  Rows rows =
      test::rowsOf(plan, [](Material material) { return "?.IO"[static_cast<int>(material)]; });
  const auto is_empty = [](const std::string& row) {
    return row.find_first_not_of('?') == std::string::npos;
  };
  rows.erase(std::remove_if(rows.begin(), rows.end(), is_empty), rows.end());
  std::size_t first = std::string::npos;
  std::size_t last = 0;
  for (const std::string& row : rows) {
    first = std::min(first, row.find_first_not_of('?'));
    last = std::max(last, row.find_last_not_of('?'));
  }
  for (std::string& row : rows) {
    row = row.substr(first, last - first + 1);
  }
  return rows;
}

FloorPlanOptions coarse() {
  FloorPlanOptions options;
  options.resolution_m = 0.1;
  return options;
}

// ---- HouseExpo ----

TEST_F(FloorPlanIo, HouseExpoOutlineBecomesFloorWithinWalls) {
  const FloorPlan plan =
      readFloorPlan(house("[[0.1,0.1],[1.1,0.1],[1.1,0.6],[0.1,0.6]]"), coarse());
  EXPECT_EQ(pictureOf(plan), (Rows{"OOOOOOOOOOOO",  //
                                   "O..........O",  //
                                   "O..........O",  //
                                   "O..........O",  //
                                   "O..........O",  //
                                   "O..........O",  //
                                   "OOOOOOOOOOOO"}));
  const Position origin = plan.geometry.origin() / 0.1;
  EXPECT_NEAR(origin.x(), std::round(origin.x()), 1e-9);
  EXPECT_NEAR(origin.y(), std::round(origin.y()), 1e-9);
  EXPECT_EQ(plan[plan.geometry.cellAt({0.15, 0.15})], Material::kFree);
  EXPECT_EQ(plan[plan.geometry.cellAt({0.05, 0.15})], Material::kOuterWall);
  EXPECT_LE(plan.geometry.box().min().x(), 0.1 - 0.5);
  EXPECT_GE(plan.geometry.box().max().y(), 0.6 + 0.5);
}

TEST_F(FloorPlanIo, SlitsAreWallAllThrough) {
  // A wall of 0.4 m from the top, with the floor below it.
  const FloorPlan plan = readFloorPlan(
      house("[[0,0],[2.4,0],[2.4,1],[1.4,1],[1.4,0.6],[1,0.6],[1,1],[0,1]]"), coarse());
  const Rows rows = test::rowsOf(toStates(plan));
  EXPECT_NE(rows[7].find("?#..........####..........#?"), std::string::npos) << rows[7];
  EXPECT_NE(rows[9].find("?#..........####..........#?"), std::string::npos) << rows[9];
  EXPECT_NE(rows[11].find("?#........................#?"), std::string::npos) << rows[11];
}

TEST_F(FloorPlanIo, WallsTooThinForACentreAreKept) {
  // Slits of 2 cm and of nothing at all, upright and level.
  const std::string upright = "[[0,0],[2,0],[2,1],[0.99,1],[0.99,0.3],[0.97,0.3],[0.97,1],[0,1]]";
  EXPECT_EQ(pictureOf(readFloorPlan(house(upright), coarse()))[3], "O.........I..........O");
  const std::string line = "[[0,0],[2,0],[2,1],[1.03,1],[1.03,0.3],[1.03,1],[0,1]]";
  EXPECT_EQ(pictureOf(readFloorPlan(house(line), coarse()))[3], "O..........I.........O");
  const std::string level = "[[0,0],[1,0],[1,2],[0,2],[0,0.99],[0.7,0.99],[0.7,0.97],[0,0.97]]";
  EXPECT_EQ(pictureOf(readFloorPlan(house(level), coarse()))[11], "OOIIIIII...O");
}

TEST_F(FloorPlanIo, EitherSenseAndAnyStartOfTheOutlineWillDo) {
  const FloorPlan one = readFloorPlan(house("[[0,0],[2,0],[2,1],[0,1]]"), coarse());
  const FloorPlan other = readFloorPlan(house("[[2,1],[2,0],[0,0],[0,1]]"), coarse());
  EXPECT_EQ(one.cells, other.cells);
}

TEST_F(FloorPlanIo, SaysWhatIsWrongWithAHouse) {
  EXPECT_EQ(complaintOf(house("[[0,0],[1,0],[1,1]")), "not valid JSON");
  EXPECT_EQ(complaintOf(write("a.json", "{\"vertices\": []}")),
            "not a HouseExpo plan: 'verts', a list of [x, y], is missing");
  EXPECT_EQ(complaintOf(write("b.json", "[1, 2]")),
            "not a HouseExpo plan: 'verts', a list of [x, y], is missing");
  EXPECT_EQ(complaintOf(house("[[0,0],[1,0]]")), "'verts' has 2 vertices; an outline needs three");
  EXPECT_EQ(complaintOf(house("[[0,0],[1,null],[1,1]]")),
            "'verts': vertex 2 must be a pair of numbers");
  EXPECT_EQ(complaintOf(house("[[0,0],[1,0],3]")), "'verts': vertex 3 must be a pair of numbers");
  EXPECT_EQ(complaintOf(house("[[0,0],[NaN,0],[1,1]]")), "not valid JSON");
  EXPECT_EQ(complaintOf(house("[[0,0],[1e7,0],[1,1]]")),
            "'verts': vertex 2 must lie within 1000 km of the origin");
  EXPECT_EQ(complaintOf(house("[[0,0],[1e999,0],[1,1]]")), "not valid JSON");
  EXPECT_EQ(complaintOf(house("[[0,0],[0,0],[0,0]]")), "the plan has no free cell");
}

TEST_F(FloorPlanIo, RefusesHostileSizes) {
  EXPECT_EQ(complaintOf(house("[[0,0],[1000,0],[1000,1000],[0,1000]]")),
            "the plan would have more than 64 million cells; choose a coarser resolution");
  EXPECT_EQ(complaintOf(house("[[0,0],[900000,0],[900000,1],[0,1]]")),
            "the plan would have more than 64 million cells; choose a coarser resolution");
  std::string comb = "[[0,0]";
  for (int i = 0; i < 20000; ++i) {
    comb += ",[" + std::to_string(i) + "e-3,300],[" + std::to_string(i) + "e-3,0]";
  }
  EXPECT_EQ(complaintOf(house(comb + "]")), "the outline is too intricate for this resolution");
}

// ---- map_server ----

TEST_F(FloorPlanIo, ReadsMapServer) {
  write("map.pgm", "P2 5 3 255  0 0 0 0 0  0 254 205 254 0  0 0 0 0 0");
  const std::string file =
      write("map.yaml", "image: map.pgm\nresolution: 0.1\norigin: [-1, 2, 0]\nmode: scale\n");
  const FloorPlan plan = readFloorPlan(file);
  EXPECT_EQ(test::rowsOf(toStates(plan)), (Rows{"#####", "#.?.#", "#####"}));
  EXPECT_EQ(plan.geometry, GridGeometry(0.1, {-1.0, 2.0}, 5, 3));
}

TEST_F(FloorPlanIo, APgmAloneIsNoPlan) {
  const std::string file = write("map.pgm", "P2 1 1 255 254");
  EXPECT_EQ(complaintOf(file),
            "not a plan: give a HouseExpo .json, a map_server .yaml (for a .pgm, the one beside "
            "it) or a .png");
}

// ---- Files and options ----

TEST_F(FloorPlanIo, ContentDecidesWhereTheNameDoesNot) {
  const std::string house_file = house("[[0,0],[1,0],[1,1]]");
  std::filesystem::copy(house_file, path("house"));
  EXPECT_EQ(readFloorPlan(path("house")).cells, readFloorPlan(house_file).cells);
}

TEST_F(FloorPlanIo, NamesAMissingFile) {
  for (const char* name : {"no.json", "no.yaml", "no.png", "no"}) {
    EXPECT_NE(complaintOf(path(name)).find("cannot be read"), std::string::npos);
  }
}

TEST_F(FloorPlanIo, ListsEveryBadOption) {
  FloorPlanOptions options;
  options.resolution_m = 0.0;
  options.metres_per_pixel = std::nan("");
  EXPECT_EQ(complaint("plan.json", options),
            "resolution must lie in 0.001..10 m; it is 0\n"
            "metres_per_pixel must lie in 0.001..10 m; it is nan");
}

// ---- Real plans ----

TEST(FloorPlanIoRealPlans, ReadsEachOne) {
  const std::vector<std::string> files = test::floorPlans();
  if (files.empty()) {
    GTEST_SKIP() << test::kNoFloorPlans;
  }
  for (const std::string& file : files) {
    const FloorPlan plan = readFloorPlan(file);
    const auto count = [&](Material material) {
      return std::count(plan.cells.begin(), plan.cells.end(), material);
    };
    const double cell = plan.geometry.resolution() * plan.geometry.resolution();
    EXPECT_GT(static_cast<double>(count(Material::kFree)) * cell, 30.0) << file;
    EXPECT_GT(count(Material::kOuterWall), 100) << file;
    EXPECT_GT(count(Material::kInteriorWall), 10) << file;
  }
}

}  // namespace
}  // namespace sfw
