#include "evaluation/scoring_suite.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "evaluation/ablations.h"
#include "simulation/building/floor_plan_generator.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/settings_io.h"

namespace sfw {
namespace {

/// A drive through a small flat without noise.
Scenario drive() {
  BuildingConfig plan;
  plan.area_m2 = 40.0;
  ScenarioConfig scenario;
  scenario.noise = noiseLevel("none");
  return makeScenario(generateFloorPlan(plan), {}, scenario);
}

std::vector<std::string> makersOf(const std::vector<BenchmarkMetrics>& maps) {
  std::vector<std::string> makers;
  for (const BenchmarkMetrics& map : maps) {
    makers.push_back(map.made_by);
  }
  return makers;
}

const MapMetrics& madeBy(const std::vector<BenchmarkMetrics>& maps, const std::string& maker) {
  return std::find_if(maps.begin(), maps.end(),
                      [&](const BenchmarkMetrics& map) { return map.made_by == maker; })
      ->metrics;
}

TEST(Benchmark, UsesTheShippedThresholdOfTheMethodOfThePaper) {
  Config config;
  benchmarkMethods({"k_visibility"}).front().select(config);
  const std::string file = std::string(SFW_SOURCE_DIR) + "/config/k_visibility.yaml";
  EXPECT_EQ(config.belief.free_threshold, readConfig(file).config.belief.free_threshold);
}

TEST(Benchmark, KnowsItsMethodsByName) {
  const std::vector<BenchmarkMethod> all = benchmarkMethods();
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all.front().name, Config().method);
  EXPECT_EQ(benchmarkMethods(std::vector<std::string>{}).size(), all.size());
  EXPECT_EQ(benchmarkMethods({"k_visibility", "k_visibility"}).size(), 1U);
  try {
    benchmarkMethods({"k_visibility", "magic"});
    FAIL() << "magic is no method";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("'magic'"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("k_visibility"), std::string::npos);
  }
}

TEST(Benchmark, ListsAblationsAndReferencesBesideEachMethod) {
  const auto maps = runBenchmark(drive(), benchmarkMethods({"k_visibility"}), Config());
  std::vector<std::string> expected{"k_visibility, K-means k", "k_visibility, true k"};
  expected.insert(expected.end(), kRadioShifts, "k_visibility, shifted radio");
  expected.insert(expected.end(), {"k_visibility, no radio", "every ray is free", "path only"});
  EXPECT_EQ(makersOf(maps), expected);
}

TEST(Benchmark, TheAblationsHaveLessRadioThanTheMethod) {
  const auto maps = runBenchmark(drive(), benchmarkMethods({"k_visibility"}), Config());
  const auto wall_f1 = [&](const char* maker) {
    return madeBy(maps, maker).wall_two_cells.value().f1.value_or(0.0);
  };
  EXPECT_GT(wall_f1("k_visibility, true k"), 0.2);
  EXPECT_LT(wall_f1("k_visibility, shifted radio"), 0.5 * wall_f1("k_visibility, true k"));
  EXPECT_EQ(wall_f1("k_visibility, no radio"), 0.0);
  EXPECT_EQ(madeBy(maps, "every ray is free").observed_walls_called_free, 1.0);
}

TEST(Benchmark, AMethodSelectsItself) {
  std::vector<BenchmarkMethod> methods{
      {"wide", "as shipped", false, [](Config& config) { config.path.footprint_radius_m = 0.4; }}};
  const auto maps = runBenchmark(drive(), methods, Config());
  EXPECT_EQ(maps.front().made_by, "wide, as shipped");
  EXPECT_EQ(makersOf(maps).size(), std::size_t{1 + kRadioShifts + 1 + 2});
  const auto usual = runBenchmark(drive(), benchmarkMethods({"k_visibility"}), Config());
  EXPECT_GT(madeBy(maps, "wide, no radio").free.iou,
            madeBy(usual, "k_visibility, no radio").free.iou);
  EXPECT_EQ(madeBy(maps, "path only").free.iou, madeBy(usual, "path only").free.iou);
}

}  // namespace
}  // namespace sfw
