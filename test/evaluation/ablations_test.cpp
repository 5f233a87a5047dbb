#include "evaluation/ablations.h"

#include <gtest/gtest.h>

#include "structure_from_wifi/mapper.h"
#include "support/evaluation_world.h"

namespace sfw::test {
namespace {

Bssid bssid(const char* text) { return *Bssid::parse(text); }

/// Nine readings of each of two radios, in turns, along the middle of the left room.
std::vector<Reading> twoRadios(bool with_wall) {
  std::vector<Reading> readings;
  for (int i = 0; i < 9; ++i) {
    const Position antenna = at(1.0 + 0.5 * i, 3.0);
    const double rssi_dbm = with_wall && i >= 5 ? -60.0 : -40.0;
    readings.push_back({i, antenna, bssid("02:00:00:00:00:01"), rssi_dbm - i});
    readings.push_back({i, antenna, bssid("02:00:00:00:00:02"), -30.0 - i});
  }
  return readings;
}

TEST(Ablations, AShiftMovesEachRadiosSignalsAlongThePath) {
  const std::vector<Reading> readings = twoRadios(false);
  const std::vector<Reading> shifted = withShiftedRadio(readings, 2);
  ASSERT_EQ(shifted.size(), readings.size());
  for (std::size_t i = 0; i < readings.size(); ++i) {
    // Two ninths of nine readings: two places on, and two rows of the table for each.
    EXPECT_EQ(shifted[i].rssi_dbm, readings[(i + 4) % readings.size()].rssi_dbm) << i;
    EXPECT_EQ(shifted[i].bssid, readings[i].bssid) << i;
    EXPECT_EQ(shifted[i].antenna_in_map, readings[i].antenna_in_map) << i;
    EXPECT_EQ(shifted[i].stamp_ns, readings[i].stamp_ns) << i;
  }
}

TEST(Ablations, WithoutRadioOnlyTheFootprintIsLeftOfWallCounts) {
  AccessPoint access_point;
  access_point.bssid = bssid("02:00:00:00:00:01");
  access_point.position = at(5.0, 5.0);
  Config config;
  config.method = "k_visibility";
  config.path.footprint_radius_m = 0.0;  // the cells of the path alone
  EvaluationInput input = rooms();
  const AblationMetrics ablations =
      evaluateAblations(input, twoRadios(true), {access_point}, config);
  ASSERT_EQ(ablations.shifted_radio.size(), static_cast<std::size_t>(kRadioShifts));
  // Five cells of the row y = 3 out of the room's 25.
  EXPECT_DOUBLE_EQ(ablations.no_radio.free.recall, 0.2);
  EXPECT_DOUBLE_EQ(ablations.no_radio.free.precision, 1.0);
}

TEST(Ablations, TheyAreTheMetricsOfAMapperWithTheShiftedReadings) {
  AccessPoint access_point;
  access_point.bssid = bssid("02:00:00:00:00:01");
  access_point.position = at(5.0, 5.0);
  const Config config;
  const std::vector<Reading> readings = twoRadios(true);
  EvaluationInput input = rooms();
  const AblationMetrics ablations = evaluateAblations(input, readings, {access_point}, config);
  Mapper mapper(config, {access_point});
  for (const Reading& reading : withShiftedRadio(readings, 3)) {
    mapper.insert(reading);
  }
  const auto snapshot = mapper.infer();
  setBelief(snapshot->belief, snapshot->probability, input);
  EXPECT_EQ(ablations.shifted_radio[2].free.iou, evaluate(input).map.free.iou);
}

}  // namespace
}  // namespace sfw::test
