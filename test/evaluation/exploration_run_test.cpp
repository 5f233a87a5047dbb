#include "evaluation/exploration_run.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "evaluation/exploration_peers.h"
#include "evaluation/exploration_score.h"
#include "simulation/building/floor_plan_io.h"
#include "simulation/scenario.h"
#include "structure_from_wifi/input_error.h"
#include "support/complaint.h"

namespace sfw::test {
namespace {

const RobotPose kCorridor{{5.0, 3.75}, 0.0};

FloorPlan demoFlat() {
  return readFloorPlan(std::string(SFW_SOURCE_DIR) + "/config/demo/flat.yaml", {});
}

struct Outcome {
  ExplorationReport report;
  ExplorationScore score;
};

Outcome explore(const std::string& policy, double time_s, std::int64_t seed = 1) {
  const FloorPlan plan = demoFlat();
  ExplorationRunConfig config;
  config.seed = seed;
  config.access_points = placeAccessPoints(plan, 2, seed);
  config.report_s = {time_s};
  const auto driver = makeExplorationPolicy(policy, plan, kCorridor.position, seed);
  Outcome outcome;
  outcome.report = runExploration(plan, kCorridor, *driver, config).back();
  outcome.score = ExplorationScorer(plan, kCorridor.position).scoreOf(*outcome.report.map);
  return outcome;
}

TEST(ExplorationRun, TheExplorerLearnsMoreThanItsPeers) {
  const Outcome own = explore("explorer", 300.0);
  EXPECT_EQ(own.report.time_s, 300.0);
  EXPECT_GT(own.score.known_m2, 20.0);
  EXPECT_LT(own.score.wrong_m2, 0.1 * own.score.known_m2);
  EXPECT_GT(own.score.known_m2, explore("nearest_frontier", 300.0).score.known_m2);
  const Outcome wall = explore("wall_following", 300.0);
  EXPECT_GT(own.score.known_m2, wall.score.known_m2);
  EXPECT_LT(own.report.touches, wall.report.touches / 2);
}

TEST(ExplorationRun, EveryPolicyDrivesAndTheSameSeedDrivesTheSame) {
  for (const std::string& name : explorationPolicyNames()) {
    const Outcome one = explore(name, 30.0);
    EXPECT_GT(one.report.driven_m, 0.3) << name;
    const Outcome other = explore(name, 30.0);
    EXPECT_EQ(one.report.driven_m, other.report.driven_m) << name;
    EXPECT_EQ(one.score.known_m2, other.score.known_m2) << name;
  }
}

TEST(ExplorationRun, APersonOnAKnownRouteTouchesNothing) {
  EXPECT_EQ(explore("walls", 120.0).report.touches, 0u);
}

TEST(ExplorationRun, NamesAnUnknownPolicy) {
  const FloorPlan plan = demoFlat();
  const std::string text =
      complaintOf([&] { makeExplorationPolicy("greedy", plan, kCorridor.position, 1); });
  EXPECT_NE(text.find("'greedy'"), std::string::npos) << text;
  EXPECT_NE(text.find("wall_following"), std::string::npos) << text;
}

}  // namespace
}  // namespace sfw::test
