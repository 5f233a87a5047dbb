// k-visibility on recorded floor plans, where the shared data is at hand.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "k_visibility_checks.h"
#include "structure_from_wifi/map_server.h"
#include "structure_from_wifi/random.h"

namespace sfw {
namespace {

using test::InverseFigures;

std::filesystem::path sharedFolder() {
  const char* folder = std::getenv("SFW_SHARED");
  return folder != nullptr ? folder : SFW_SOURCE_DIR "/../shared";
}

constexpr std::uint64_t kPlaces = 2;  // of access points, in each plan

/// A free cell by chance.
Position freePlace(const Grid<CellState>& plan, std::uint64_t item) {
  Random random(1, 1, item);
  const GridGeometry& geometry = plan.geometry;
  while (true) {
    const Position at = geometry.origin() + geometry.box().sizes().cwiseProduct(
                                                Position(random.uniform(), random.uniform()));
    const Cell c = geometry.cellAt(at);
    if (geometry.contains(c) && plan[c] == CellState::kFree) {
      return at;
    }
  }
}

class RealPlan : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const auto file = sharedFolder() / "data/floorplans/real" / GetParam();
    if (!std::filesystem::exists(file)) {
      GTEST_SKIP() << "no floor plan at " << file << "; SFW_SHARED may name the shared folder";
    }
    plan_ = readMap(file.string());
  }

  std::optional<Grid<CellState>> plan_;
};

TEST_P(RealPlan, ForwardAgreesWithRays) {
  for (std::uint64_t i = 0; i < kPlaces; ++i) {
    const Position access_point = freePlace(*plan_, i);
    EXPECT_GE(test::agreement(*plan_, access_point, test::runsOfWall), 0.995)
        << access_point.transpose();
  }
}

TEST_P(RealPlan, DenseInverseFindsTheWalls) {
  for (std::uint64_t i = 0; i < kPlaces; ++i) {
    const Position access_point = freePlace(*plan_, i);
    const InverseFigures figures = test::inverseFigures(*plan_, access_point);
    EXPECT_GE(figures.found, 0.99) << access_point.transpose();
    EXPECT_LE(figures.falsely, 0.01) << access_point.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(MapServer, RealPlan,
                         testing::Values("small_house/map.yaml", "office_floor/1n.yaml"),
                         [](const testing::TestParamInfo<const char*>& plan) {
                           return std::string(plan.param, std::string(plan.param).find('/'));
                         });

}  // namespace
}  // namespace sfw
