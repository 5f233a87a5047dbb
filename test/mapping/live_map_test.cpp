#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <vector>

#include "simulation/building/floor_plan_generator.h"
#include "simulation/scenario.h"
#include "simulation/simulated_recording.h"
#include "support/mapper_scene.h"

// A live map keeps results from one refresh to the next. These tests hold what that may change.

namespace sfw {
namespace {

const std::atomic<bool> kNever{false};
constexpr int kMembers = 8;

/// A drive through a small flat.
class LiveMap : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    ScenarioConfig config;
    config.access_points = 2;
    config.noise = noiseLevel("moderate");  // exact poses, so the building does not turn
    BuildingConfig building;
    building.area_m2 = 40.0;
    const Scenario scenario = makeScenario(generateFloorPlan(building), {}, config);
    access_points_ = new std::vector<AccessPoint>(scenario.access_points);
    readings_ = new std::vector<Reading>(simulate(scenario).readings);
  }

  static void TearDownTestSuite() {
    delete access_points_;
    delete readings_;
  }

  /// Inserts the readings up to a share of the drive.
  void driveTo(double share) {
    const auto end = static_cast<std::size_t>(share * static_cast<double>(readings_->size()));
    for (; inserted_ < end; ++inserted_) {
      mapper_.insert((*readings_)[inserted_]);
    }
  }

  std::shared_ptr<const Snapshot> refresh() { return mapper_.refresh(cache_, kNever); }

  /// Refreshes without new readings until the map is that of infer().
  int refreshesUntilFinished() {
    int count = 0;
    for (; cache_.isUnfinished() && count < 100; ++count) {
      refresh();
    }
    return count;
  }

  static inline std::vector<AccessPoint>* access_points_ = nullptr;
  static inline std::vector<Reading>* readings_ = nullptr;
  std::size_t inserted_ = 0;
  Mapper mapper_{Config(), *access_points_};
  RefreshCache cache_;
};

double shareOfOtherStates(const Snapshot& one, const Snapshot& other) {
  const GridGeometry& geometry = one.belief.geometry();
  EXPECT_EQ(geometry, other.belief.geometry());
  std::size_t count = 0;
  for (std::size_t i = 0; i < geometry.size(); ++i) {
    count += one.belief.state(geometry.cell(i)) != other.belief.state(geometry.cell(i)) ? 1 : 0;
  }
  return static_cast<double>(count) / static_cast<double>(geometry.size());
}

TEST_F(LiveMap, BeginsAsTheInferredMap) {
  driveTo(0.5);
  EXPECT_EQ(test::hashOf(*refresh()), test::hashOf(*mapper_.infer()));
  EXPECT_FALSE(cache_.isUnfinished());
}

TEST_F(LiveMap, IsCloseToTheInferredMapWhileTheRobotDrives) {
  driveTo(0.6);
  refresh();
  double most = 0.0;
  double sum = 0.0;
  constexpr int kRefreshes = 30;
  for (int i = 1; i <= kRefreshes; ++i) {
    driveTo(0.6 + 0.01 * i);
    const double share = shareOfOtherStates(*refresh(), *mapper_.infer());
    most = std::max(most, share);
    sum += share;
  }
  EXPECT_LT(most, 0.02);
  EXPECT_LT(sum / kRefreshes, 0.005);
  EXPECT_GT(most, 0.0) << "nothing is kept";
}

TEST_F(LiveMap, BecomesTheInferredMapWithoutNewReadings) {
  driveTo(0.9);
  refresh();
  driveTo(0.92);
  refresh();
  EXPECT_TRUE(cache_.isUnfinished());
  EXPECT_EQ(refreshesUntilFinished(), kMembers - 1);
  EXPECT_EQ(test::hashOf(*refresh()), test::hashOf(*mapper_.infer()));
}

TEST_F(LiveMap, OtherSettingsStartAnew) {
  driveTo(0.9);
  refresh();
  Config config;
  config.tomography.ensemble_size = 4;
  config.tomography.l1_weight = 0.1;
  mapper_.configure(config);
  EXPECT_EQ(test::hashOf(*refresh()), test::hashOf(*mapper_.infer()));
}

TEST_F(LiveMap, AClearedCacheStartsAnew) {
  driveTo(0.9);
  refresh();
  driveTo(0.95);
  cache_.clear();
  EXPECT_EQ(test::hashOf(*refresh()), test::hashOf(*mapper_.infer()));
}

TEST_F(LiveMap, ARefreshEndsWhenItIsStopped) {
  driveTo(0.5);
  const std::atomic<bool> stop{true};
  EXPECT_EQ(mapper_.refresh(cache_, stop), nullptr);
  EXPECT_EQ(test::hashOf(*refresh()), test::hashOf(*mapper_.infer()));
}

TEST_F(LiveMap, OfKVisibilityIsTheInferredMap) {
  Config config;
  config.method = "k_visibility";
  mapper_.configure(config);
  driveTo(0.5);
  refresh();
  driveTo(0.52);
  EXPECT_EQ(test::hashOf(*refresh()), test::hashOf(*mapper_.infer()));
  EXPECT_FALSE(cache_.isUnfinished());
}

}  // namespace
}  // namespace sfw
