// k-visibility on 24 homes of HouseExpo and two map_server plans, where they are at hand.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/random.h"
#include "simulation/building/floor_plan_io.h"
#include "support/floor_plans.h"
#include "support/k_visibility_checks.h"

namespace sfw {
namespace {

using test::InverseFigures;

/// A free cell by chance.
Cell freeCell(const Grid<CellState>& plan, Random& random) {
  const GridGeometry& geometry = plan.geometry;
  const Position size(static_cast<double>(geometry.width()),
                      static_cast<double>(geometry.height()));
  while (true) {
    const Cell c{static_cast<std::int64_t>((1.0 - random.uniform()) * size.x()),
                 static_cast<std::int64_t>((1.0 - random.uniform()) * size.y())};
    if (plan[c] == CellState::kFree) {
      return c;
    }
  }
}

/// Access points anywhere in a cell, in its centre and on its corner: from the last two every third
/// ray goes exactly through corners.
std::vector<Position> places(const Grid<CellState>& plan) {
  Random random(1, 1, 1);
  std::vector<Position> all;
  for (const double within : {random.uniform(), 0.5, 0.0}) {
    const Cell c = freeCell(plan, random);
    all.push_back(plan.geometry.centre(c) +
                  (within - 0.5) * plan.geometry.resolution() * Position::Ones());
  }
  return all;
}

class RealPlan : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (GetParam().empty()) {
      GTEST_SKIP() << test::kNoFloorPlans;
    }
    plan_ = toStates(readFloorPlan(GetParam()));
  }

  std::optional<Grid<CellState>> plan_;
};

TEST_P(RealPlan, ForwardAgreesWithRays) {
  for (const Position& access_point : places(*plan_)) {
    EXPECT_GE(test::agreement(*plan_, access_point, test::runsOfWall), 0.995)
        << access_point.transpose();
  }
}

TEST_P(RealPlan, ForwardIsWhatTheRadioCounts) {
  for (const Position& access_point : places(*plan_)) {
    EXPECT_GE(test::agreement(*plan_, access_point, test::radioCount), 0.9999)
        << access_point.transpose();
  }
}

TEST_P(RealPlan, DenseInverseFindsTheWalls) {
  for (const Position& access_point : places(*plan_)) {
    const InverseFigures figures = test::inverseFigures(*plan_, access_point);
    EXPECT_GE(figures.found, 0.99) << access_point.transpose();
    EXPECT_LE(figures.falsely, 0.01) << access_point.transpose();
  }
}

std::vector<std::string> plansOrNone() {
  std::vector<std::string> files = test::floorPlans();
  return files.empty() ? std::vector<std::string>{""} : files;
}

/// The folder's and the file's name, as far as a test's name may hold them.
std::string nameOf(const testing::TestParamInfo<std::string>& plan) {
  const std::filesystem::path file(plan.param);
  std::string name = file.parent_path().filename().string() + "_" + file.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return file.empty() ? "none_at_hand" : name;
}

INSTANTIATE_TEST_SUITE_P(All, RealPlan, testing::ValuesIn(plansOrNone()), nameOf);

}  // namespace
}  // namespace sfw
