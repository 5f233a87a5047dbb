#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>

#include "belief/free_probability.h"
#include "grid/robot_evidence.h"
#include "mapping/fused_belief.h"
#include "simulation/building/floor_plan_generator.h"
#include "simulation/scenario.h"
#include "structure_from_wifi/mapper.h"
#include "training/training_drive.h"
#include "walls/network_walls.h"

namespace sfw::test {
namespace {

/// Compares predicted probabilities of free space with the shares of cells that are free.
class Reliability {
 public:
  void add(double predicted, bool is_free) {
    const auto tenth =
        static_cast<std::size_t>(std::min(predicted * kTenths, static_cast<double>(kTenths - 1)));
    predicted_[tenth] += predicted;
    free_[tenth] += is_free ? 1.0 : 0.0;
    cells_[tenth] += 1.0;
  }

  /// Expects that both agree within .1 in each tenth with enough cells.
  /// @param least_tenths  so many tenths must have enough of them
  void expectCalibrated(int least_tenths) const {
    constexpr double kEnough = 100.0;
    int judged = 0;
    for (std::size_t tenth = 0; tenth < kTenths; ++tenth) {
      if (cells_[tenth] < kEnough) {
        continue;
      }
      ++judged;
      const double predicted = predicted_[tenth] / cells_[tenth];
      const double free = free_[tenth] / cells_[tenth];
      std::printf("predicted %.2f, free %.2f in %.0f cells\n", predicted, free, cells_[tenth]);
      EXPECT_NEAR(predicted, free, 0.1);
    }
    EXPECT_GE(judged, least_tenths);
  }

 private:
  static constexpr std::size_t kTenths = 10;
  std::array<double, kTenths> predicted_{};
  std::array<double, kTenths> free_{};
  std::array<double, kTenths> cells_{};
};

DriveData dataOf(const TrainingDrive& drive) {
  DriveData data;
  for (const AccessPoint& one : drive.access_points) {
    data.access_points.push_back({one.position, one.height_m, {}});
  }
  for (const Reading& reading : drive.readings) {
    data.path.push_back(reading.antenna_in_map);
    for (std::size_t i = 0; i < data.access_points.size(); ++i) {
      if (drive.access_points[i].bssid == reading.bssid) {
        data.access_points[i].samples.push_back({reading.antenna_in_map, reading.rssi_dbm});
      }
    }
  }
  return data;
}

FloorPlan generatedFlat(std::int64_t seed, double area_m2) {
  BuildingConfig building;
  building.seed = static_cast<std::uint64_t>(seed);
  building.area_m2 = area_m2;
  return generateFloorPlan(building);
}

// No drive of these tests was used for the shipped model: `sfw fit --seed 1` takes 1000000 and up.

TEST(Calibration, BeliefModelIsRightWithinATenth) {
  const BeliefModel model = shippedBeliefModel();
  const std::atomic<bool> never{false};
  Reliability reliability;
  for (int i = 0; i < 72; ++i) {
    const std::int64_t seed = 990000 + i;
    const auto style = static_cast<DrivingStyle>(i % kDrivingStyles);
    const auto drive = makeTrainingDrive(generatedFlat(seed, 40.0 + 1.3 * i), style, seed);
    if (!drive) {
      continue;
    }
    const DriveFeatures described = extractDriveFeatures(dataOf(*drive), Config(), never);
    const StyleShares shares = model.shares(described.cells.style);
    const Grid<float> probability = freeProbability(described.cells, model, shares, UseRadio::kYes);
    for (std::size_t k = 0; k < described.cells.cells.size(); k += 7) {
      const std::size_t cell = described.cells.cells[k];
      const Position centre = described.cells.geometry.centre(described.cells.geometry.cell(cell));
      const Cell at = drive->truth.geometry.cellAt(described.frame.toMap(centre));
      reliability.add(probability.cells[cell],
                      drive->truth.geometry.contains(at) && drive->truth[at] == CellState::kFree);
    }
  }
  reliability.expectCalibrated(10);
}

TEST(Calibration, ProbabilityOfTheMapIsRightWithinATenth) {
  Reliability reliability;
  for (int i = 0; i < 16; ++i) {
    const std::int64_t seed = 980000 + i;
    ScenarioConfig config;
    config.seed = seed;
    config.access_points = 2;
    const Scenario scenario = makeScenario(generatedFlat(seed, 40.0 + 5.0 * i), {}, config);
    Mapper mapper(Config(), scenario.access_points);
    for (const Reading& reading : simulate(scenario).readings) {
      mapper.insert(reading);
    }
    const auto snapshot = mapper.infer();
    const GridGeometry& geometry = snapshot->probability.geometry();
    for (std::size_t k = 0; k < geometry.size(); ++k) {
      const double occupied = snapshot->probability.occupied(geometry.cell(k));
      const Cell at = scenario.plan.geometry.cellAt(geometry.centre(geometry.cell(k)));
      if (occupied != kUnknownOccupancy && scenario.plan.geometry.contains(at)) {
        reliability.add(1.0 - occupied, scenario.plan[at] == Material::kFree);
      }
    }
  }
  reliability.expectCalibrated(5);
}

TEST(Calibration, KeepsTheOrderOfCells) {
  for (float p = 0.0F; p < 0.999F; p += 0.01F) {
    EXPECT_LT(calibratedOccupancy(p), calibratedOccupancy(p + 0.01F));
  }
  EXPECT_FLOAT_EQ(calibratedOccupancy(0.3F), 0.3F);
  EXPECT_LT(calibratedOccupancy(1.0F), 0.6F);
}

}  // namespace
}  // namespace sfw::test
