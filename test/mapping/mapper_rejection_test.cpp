#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "structure_from_wifi/input_error.h"
#include "support/mapper_scene.h"

namespace sfw {
namespace {

using namespace test;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Mapper, RefusesWhatItCannotUseAndKeepsItsMap) {
  Mapper mapper = mapperOf(drive());
  const GridGeometry geometry = mapper.geometry();
  const auto map_of = [](const Mapper& m) {
    const auto snapshot = m.infer();
    return hashOf(trinaryPgm(snapshot->belief) + probabilityPgm(snapshot->probability));
  };
  const std::uint64_t before = map_of(mapper);
  const std::vector<std::pair<Reading, InsertResult>> cases{
      {reading(99, kNaN, 0, -40), InsertResult::kPositionNotFinite},
      {reading(99, 0, kInfinity, -40), InsertResult::kPositionNotFinite},
      {reading(99, 1e305, 0, -40), InsertResult::kPositionNotFinite},
      {reading(99, 5000, 5000, -40), InsertResult::kPositionTooFar},
      {reading(99, 1e17, 0, -40), InsertResult::kPositionTooFar},
      {reading(99, 0, 0, kNaN), InsertResult::kRssiNotFinite},
      {reading(99, 0, 0, -kInfinity), InsertResult::kRssiNotFinite},
      {reading(99, 0, 0, 0.01), InsertResult::kRssiOutOfRange},
      {reading(99, 0, 0, 70), InsertResult::kRssiOutOfRange},
      {reading(99, 0, 0, -120), InsertResult::kRssiOutOfRange},
      {reading(99, 0, 0, -1e300), InsertResult::kRssiOutOfRange},
      {reading(99, 90, 0, 70, 77), InsertResult::kRssiOutOfRange}};
  for (const auto& [refused, reason] : cases) {
    EXPECT_EQ(mapper.insert(refused), reason) << refused.antenna_in_map << refused.rssi_dbm;
  }
  const Contact nowhere{0, {kNaN, 0}};
  const Contact far{0, {5000, -5000}};
  const Contact farther{0, {0, -1e18}};
  EXPECT_EQ(mapper.insert(nowhere), InsertResult::kPositionNotFinite);
  EXPECT_EQ(mapper.insert(far), InsertResult::kPositionTooFar);
  EXPECT_EQ(mapper.insert(farther), InsertResult::kPositionTooFar);
  EXPECT_EQ(mapper.geometry(), geometry);
  EXPECT_EQ(map_of(mapper), before);
  const std::map<InsertResult, std::size_t> expected{{InsertResult::kPositionNotFinite, 4},
                                                     {InsertResult::kPositionTooFar, 4},
                                                     {InsertResult::kRssiNotFinite, 2},
                                                     {InsertResult::kRssiOutOfRange, 5}};
  EXPECT_EQ(mapper.rejections().count, expected);
}

TEST(Mapper, TakesSignalsUpToTheirLimits) {
  Mapper mapper = mapperOf({});
  EXPECT_EQ(mapper.insert(reading(1, 0, 0, 0.0)), InsertResult::kAccepted);
  EXPECT_EQ(mapper.insert(reading(2, 0, 0, -119.9)), InsertResult::kAccepted);
}

TEST(Mapper, RefusesMoreReadingsThanAllowed) {
  Config config = rawConfig();
  config.map.max_readings = 2;
  Mapper mapper(config, {accessPoint(1, 0, 0)});
  EXPECT_EQ(mapper.insert(reading(1, 1, 1, -40)), InsertResult::kAccepted);
  EXPECT_EQ(mapper.insert(reading(2, 1, 1, -40, 9)), InsertResult::kUnknownAccessPoint);
  const GridGeometry geometry = mapper.geometry();
  EXPECT_EQ(mapper.insert(reading(3, 50, 1, -40)), InsertResult::kTooManyReadings);
  EXPECT_EQ(mapper.geometry(), geometry);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(mapper.insert(Contact{i, {1, 1}}), InsertResult::kAccepted);
  }
  EXPECT_EQ(mapper.insert(Contact{3, {1, 1}}), InsertResult::kTooManyReadings);
  EXPECT_EQ(mapper.rejections().count.at(InsertResult::kTooManyReadings), 2U);
  EXPECT_EQ(mapper.readings().size(), 2U);
}

TEST(Mapper, SaysWhyForEachReason) {
  for (const InsertResult reason :
       {InsertResult::kAccepted, InsertResult::kPositionNotFinite, InsertResult::kPositionTooFar,
        InsertResult::kRssiNotFinite, InsertResult::kRssiOutOfRange,
        InsertResult::kUnknownAccessPoint, InsertResult::kTooManyReadings}) {
    EXPECT_STRNE(toString(reason), "");
  }
}

TEST(Mapper, RefusesSettingsAndTablesThatItCannotUse) {
  Config broken;
  broken.map.resolution_m = kNaN;
  EXPECT_THROW(Mapper(broken, {accessPoint(1, 0, 0)}), InputError);
  EXPECT_THROW(Mapper(Config(), {accessPoint(1, 0, 0), accessPoint(1, 1, 1)}), InputError);
  EXPECT_THROW(Mapper(Config(), {accessPoint(1, 0, 0), accessPoint(2, 4000, 4000)}), InputError);
  EXPECT_THROW(Mapper(Config(), {accessPoint(1, 9e5, 9e5)}), InputError);
  for (const double bad : {kNaN, kInfinity}) {
    EXPECT_THROW(Mapper(Config(), {accessPoint(1, 0, 0), accessPoint(2, bad, 0)}), InputError);
    EXPECT_THROW(Mapper(Config(), {accessPoint(2, bad, 0), accessPoint(1, 0, 0)}), InputError);
  }
}

}  // namespace
}  // namespace sfw
