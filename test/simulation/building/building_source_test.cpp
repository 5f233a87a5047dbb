#include "simulation/building/building_source.h"

#include <gtest/gtest.h>

#include "structure_from_wifi/input_error.h"
#include "support/temporary_folder.h"

namespace sfw {
namespace {

using BuildingSourceFiles = test::TemporaryFolder;

TEST_F(BuildingSourceFiles, ReadsAPlanAtItsResolution) {
  BuildingSource source;
  source.plan = write("room.json", R"({"verts": [[0, 0], [3, 0], [3, 2], [0, 2]]})");
  source.options.resolution_m = 0.1;
  const FloorPlan plan = makeFloorPlan(source, 1);
  EXPECT_EQ(plan.geometry.resolution(), 0.1);
  EXPECT_EQ(plan[plan.geometry.cellAt({1.5, 1.0})], Material::kFree);
}

TEST(BuildingSource, GeneratesABuildingFromTheSeed) {
  BuildingSource source;
  source.generate = "office";
  source.area_m2 = 120.0;
  BuildingConfig office;
  office.kind = BuildingKind::kOffice;
  office.area_m2 = 120.0;
  office.seed = 4;
  EXPECT_EQ(makeFloorPlan(source, 4).cells, generateFloorPlan(office).cells);
  EXPECT_NE(makeFloorPlan(source, 5).cells, generateFloorPlan(office).cells);
}

TEST(BuildingSource, IsOneOfTheTwo) {
  BuildingSource source;
  EXPECT_THROW(makeFloorPlan(source, 1), InputError);
  source.plan = "room.json";
  source.generate = "flat";
  EXPECT_THROW(makeFloorPlan(source, 1), InputError);
  source.plan = "";
  source.generate = "castle";
  EXPECT_THROW(makeFloorPlan(source, 1), InputError);
}

}  // namespace
}  // namespace sfw
