#include "training/wall_drive.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <set>

#include "belief/free_probability.h"
#include "mapping/fused_belief.h"
#include "training/disturbance.h"
#include "training/training_world.h"
#include "walls/network_inputs.h"

namespace sfw::test {
namespace {

/// The first drive of a kind that fits into a generated building.
WallDrive driveOf(WallDriveKind kind) {
  for (std::int64_t seed = 1;; ++seed) {
    if (std::optional<WallDrive> made = makeWallDrive(makeTrainingBuilding(seed), kind, seed)) {
      return *made;
    }
  }
}

/// The inputs of the network for the readings of a drive, without the code of training.
Channels inputsOf(const TrainingDrive& drive) {
  DriveData data;
  std::map<Bssid, std::vector<Sample>> samples;
  std::int64_t last_ns = -1;
  for (const Reading& reading : drive.readings) {
    samples[reading.bssid].push_back({reading.antenna_in_map, reading.rssi_dbm});
    if (reading.stamp_ns != last_ns) {
      data.path.push_back(reading.antenna_in_map);
    }
    last_ns = reading.stamp_ns;
  }
  for (const AccessPoint& one : drive.access_points) {
    if (!samples[one.bssid].empty()) {
      data.access_points.push_back({one.position, one.height_m, samples[one.bssid]});
    }
  }
  Config config;
  config.map.resolution_m = kNetworkCellM;
  const std::atomic<bool> never{false};
  const DriveFeatures features = extractDriveFeatures(data, config, never, kTrustedVariance);
  const BeliefModel model = configuredBeliefModel(config.belief);
  const StyleShares style = model.shares(features.cells.style);
  const Mask footprint = footprintOf(features.path);
  const Grid<float> free = freeProbability(features.cells, model, style, UseRadio::kYes);
  return channelsOf(networkInputs(features, footprint, model, style, UseRadio::kYes, free));
}

TEST(WallRasters, BeginWithTheInputsOfTheNetwork) {
  for (const WallDriveKind kind :
       {WallDriveKind::kAlongWalls, WallDriveKind::kPatrol, WallDriveKind::kStroll}) {
    const WallDrive drive = driveOf(kind);
    const Channels rasters = wallRasters(drive, {});
    const Channels inputs = inputsOf(drive.drive);
    ASSERT_EQ(inputs.count(), networkInputNames().size());
    ASSERT_EQ(rasters.count(), inputs.count() + wallLabelNames().size());
    ASSERT_EQ(rasters.width(), inputs.width());
    EXPECT_TRUE(
        std::equal(inputs.values().begin(), inputs.values().end(), rasters.values().begin()))
        << nameOf(kind);
  }
}

TEST(WallRasters, LabelFreeCellsOnThePathAndWallsElsewhere) {
  const Channels rasters = wallRasters(driveOf(WallDriveKind::kSurvey), {});
  const std::size_t first = networkInputNames().size();
  const std::size_t cells = rasters.height() * rasters.width();
  const auto raster = [&](std::size_t label) { return rasters.row(first + label, 0); };
  std::size_t covered = 0;
  std::size_t free = 0;
  for (std::size_t i = 0; i < cells; ++i) {
    EXPECT_LE(raster(1)[i] + raster(2)[i], 1.0F) << "shares of one cell";
    covered += raster(0)[i] == 1.0F ? 1U : 0U;
    free += raster(0)[i] == 1.0F && raster(1)[i] > 0.5F ? 1U : 0U;
  }
  ASSERT_GT(covered, 100U);
  EXPECT_GT(static_cast<double>(free), 0.8 * static_cast<double>(covered));
  EXPECT_GT(std::count(raster(3), raster(3) + cells, 1.0F), 100);
}

TEST(WallDrive, IsTheSameForTheSameSeedOnly) {
  const FloorPlan plan = makeTrainingBuilding(1);
  const auto signals = [&](std::int64_t seed) {
    const std::optional<WallDrive> made = makeWallDrive(plan, WallDriveKind::kPatrol, seed);
    std::vector<double> rssi_dbm;
    for (const Reading& one : made.value().drive.readings) {
      rssi_dbm.push_back(one.rssi_dbm);
    }
    return rssi_dbm;
  };
  EXPECT_EQ(signals(1), signals(1));
  EXPECT_NE(signals(1), signals(2));
}

TEST(WallDrive, AllKindsComeUp) {
  std::set<WallDriveKind> kinds;
  for (std::int64_t seed = 0; seed < 100; ++seed) {
    kinds.insert(chooseWallDriveKind(seed));
  }
  EXPECT_EQ(kinds.size(), 4U);
}

TEST(Disturbance, KeepsReadingsInTheirRangeAndTheirPlaces) {
  const WallDrive drive = driveOf(WallDriveKind::kStroll);
  for (std::int64_t seed = 0; seed < 20; ++seed) {
    TrainingDrive disturbed = drive.drive;
    disturb(disturbed, noiseLevel("realistic"), seed);
    ASSERT_EQ(disturbed.readings.size(), drive.drive.readings.size());
    std::size_t changed = 0;
    for (std::size_t i = 0; i < disturbed.readings.size(); ++i) {
      EXPECT_LT(disturbed.readings[i].rssi_dbm, 0.0);
      EXPECT_GT(disturbed.readings[i].rssi_dbm, -120.0);
      EXPECT_EQ(disturbed.readings[i].antenna_in_map, drive.drive.readings[i].antenna_in_map);
      changed += disturbed.readings[i].rssi_dbm != drive.drive.readings[i].rssi_dbm ? 1U : 0U;
    }
    EXPECT_GT(changed, 0U) << "seed " << seed;
  }
}

}  // namespace
}  // namespace sfw::test
