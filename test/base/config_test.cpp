#include "structure_from_wifi/config.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace sfw {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Validate, FindsNothingWrongWithTheDefaults) {
  EXPECT_EQ(validate(Config()), std::vector<std::string>());
}

/// Sets one setting of a default configuration; the names of those that are then complained of.
template <class T>
std::vector<std::string> brokenBy(const std::string& name, T value) {
  Config config;
  forEachSetting(config, [&](const std::string& known, auto& setting) {
    if constexpr (std::is_same_v<std::decay_t<decltype(setting)>, T>) {
      setting = known == name ? value : setting;
    }
  });
  std::vector<std::string> names;
  for (const std::string& problem : validate(config)) {
    names.push_back(problem.substr(0, problem.find(' ')));
  }
  return names;
}

using Names = std::vector<std::string>;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Validate, AsksForPositiveNumbers) {
  for (const std::string name :
       {"map/resolution", "map/margin", "map/growth_step", "k_visibility/min_wall_loss",
        "path/max_gap", "k_visibility/wall_thickness", "octomap/wall_height",
        "octomap/robot_height"}) {
    for (const double bad : {0.0, -1.0, kNaN, kInfinity}) {
      EXPECT_EQ(brokenBy(name, bad), Names{name}) << bad;
    }
    EXPECT_EQ(brokenBy(name, 1e-3), Names());
  }
}

TEST(Validate, AsksForNumbersThatAreNotNegative) {
  for (const std::string name : {"k_visibility/path_loss_exponent", "path/footprint_radius"}) {
    for (const double bad : {-1e-9, kNaN, kInfinity}) {
      EXPECT_EQ(brokenBy(name, bad), Names{name}) << bad;
    }
    EXPECT_EQ(brokenBy(name, 0.0), Names());
  }
}

TEST(Validate, AsksForProbabilities) {
  for (const std::string name :
       {"k_visibility/wall_prior", "belief/free_threshold", "belief/occupied_threshold"}) {
    for (const double bad : {0.0, 1.0, -0.5, 2.0, kNaN}) {
      EXPECT_TRUE(contains(brokenBy(name, bad).front(), name)) << bad;
    }
  }
}

TEST(Validate, AsksForWholeNumbersInTheirRange) {
  for (const std::string name : {"map/max_cells", "map/max_readings"}) {
    EXPECT_EQ(brokenBy(name, std::int64_t{0}), Names{name});
    EXPECT_EQ(brokenBy(name, std::int64_t{1}), Names());
  }
  EXPECT_EQ(brokenBy("k_visibility/wall_count", std::int64_t{-1}),
            Names{"k_visibility/wall_count"});
  EXPECT_EQ(brokenBy("k_visibility/wall_count", std::int64_t{21}),
            Names{"k_visibility/wall_count"});
  EXPECT_EQ(brokenBy("k_visibility/wall_count", std::int64_t{20}), Names());
  EXPECT_EQ(brokenBy("k_visibility/max_wall_count", std::int64_t{0}),
            Names{"k_visibility/max_wall_count"});
  EXPECT_EQ(brokenBy("k_visibility/max_wall_count", std::int64_t{21}),
            Names{"k_visibility/max_wall_count"});
  for (const std::int64_t directions : {0, 3, 10}) {
    EXPECT_EQ(brokenBy("tomography/wall_directions", directions),
              Names{"tomography/wall_directions"});
  }
  EXPECT_EQ(brokenBy("tomography/wall_directions", std::int64_t{8}), Names());
}

TEST(Validate, AsksForAnOddWindow) {
  for (const std::int64_t bad : {-1, 0, 2, 10}) {
    EXPECT_EQ(brokenBy("k_visibility/window", bad), Names{"k_visibility/window"}) << bad;
  }
  EXPECT_EQ(brokenBy("k_visibility/window", std::int64_t{1}), Names());
}

TEST(Validate, AsksForKnownWords) {
  EXPECT_EQ(brokenBy("k_visibility/filter", std::string("kalman")), Names{"k_visibility/filter"});
  EXPECT_EQ(brokenBy("k_visibility/filter", std::string("mean")), Names());
}

TEST(Validate, AsksForThresholdsThatAreApart) {
  EXPECT_EQ(brokenBy("belief/free_threshold", 0.66), Names{"belief/free_threshold"});
  EXPECT_EQ(brokenBy("belief/free_threshold", 0.61), Names{"belief/free_threshold"});
  EXPECT_EQ(brokenBy("belief/free_threshold", 0.59), Names());
  EXPECT_EQ(brokenBy("belief/occupied_threshold", 0.24), Names{"belief/free_threshold"});
}

TEST(Validate, AsksForNoSaturationOrOneThatLeavesSomething) {
  EXPECT_EQ(brokenBy("tomography/max_total_wall_loss", 0.5),
            Names{"tomography/max_total_wall_loss"});
  EXPECT_EQ(brokenBy("tomography/max_total_wall_loss", 1.0), Names());
  EXPECT_EQ(brokenBy("tomography/max_total_wall_loss", 0.0), Names());
}

TEST(Validate, NamesAllProblemsAtOnceWithTheirValues) {
  Config config;
  config.map.resolution_m = -0.25;
  config.k_visibility.filter = "kalman";
  config.k_visibility.window = 4;
  config.belief.occupied_threshold = 1.5;
  const std::vector<std::string> problems = validate(config);
  ASSERT_EQ(problems.size(), 4U);
  EXPECT_TRUE(contains(problems[0], "map/resolution") && contains(problems[0], "-0.25"));
  EXPECT_TRUE(contains(problems[1], "k_visibility/filter") && contains(problems[1], "'kalman'"));
  EXPECT_TRUE(contains(problems[2], "k_visibility/window") && contains(problems[2], "4"));
  EXPECT_TRUE(contains(problems[3], "belief/occupied_threshold"));
}

}  // namespace
}  // namespace sfw
