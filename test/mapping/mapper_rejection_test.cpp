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
    return hashOf(trinaryPgm(snapshot->belief) + probabilityPgm(snapshot->belief));
  };
  const std::uint64_t before = map_of(mapper);
  const std::vector<std::pair<Reading, Insertion>> cases{
      {reading(99, kNaN, 0, -40), Insertion::kPositionNotFinite},
      {reading(99, 0, kInfinity, -40), Insertion::kPositionNotFinite},
      {reading(99, 1e305, 0, -40), Insertion::kPositionNotFinite},
      {reading(99, 5000, 5000, -40), Insertion::kPositionTooFar},
      {reading(99, 1e17, 0, -40), Insertion::kPositionTooFar},
      {reading(99, 0, 0, kNaN), Insertion::kRssiNotFinite},
      {reading(99, 0, 0, -kInfinity), Insertion::kRssiNotFinite},
      {reading(99, 0, 0, 0.01), Insertion::kRssiOutOfRange},
      {reading(99, 0, 0, 70), Insertion::kRssiOutOfRange},
      {reading(99, 0, 0, -120), Insertion::kRssiOutOfRange},
      {reading(99, 0, 0, -1e300), Insertion::kRssiOutOfRange},
      {reading(99, 90, 0, 70, 77), Insertion::kRssiOutOfRange}};
  for (const auto& [refused, reason] : cases) {
    EXPECT_EQ(mapper.insert(refused), reason) << refused.antenna_in_map << refused.rssi_dbm;
  }
  const Contact nowhere{0, {kNaN, 0}};
  const Contact far{0, {5000, -5000}};
  const Contact farther{0, {0, -1e18}};
  EXPECT_EQ(mapper.insert(nowhere), Insertion::kPositionNotFinite);
  EXPECT_EQ(mapper.insert(far), Insertion::kPositionTooFar);
  EXPECT_EQ(mapper.insert(farther), Insertion::kPositionTooFar);
  EXPECT_EQ(mapper.geometry(), geometry);
  EXPECT_EQ(map_of(mapper), before);
  const std::map<Insertion, std::size_t> expected{{Insertion::kPositionNotFinite, 4},
                                                  {Insertion::kPositionTooFar, 4},
                                                  {Insertion::kRssiNotFinite, 2},
                                                  {Insertion::kRssiOutOfRange, 5}};
  EXPECT_EQ(mapper.rejections().count, expected);
}

TEST(Mapper, TakesSignalsUpToTheirLimits) {
  Mapper mapper = mapperOf({});
  EXPECT_EQ(mapper.insert(reading(1, 0, 0, 0.0)), Insertion::kAccepted);
  EXPECT_EQ(mapper.insert(reading(2, 0, 0, -119.9)), Insertion::kAccepted);
}

TEST(Mapper, RefusesMoreReadingsThanAllowed) {
  Config config = rawConfig();
  config.map.max_readings = 2;
  Mapper mapper(config, {accessPoint(1, 0, 0)});
  EXPECT_EQ(mapper.insert(reading(1, 1, 1, -40)), Insertion::kAccepted);
  EXPECT_EQ(mapper.insert(reading(2, 1, 1, -40, 9)), Insertion::kUnknownAccessPoint);
  const GridGeometry geometry = mapper.geometry();
  EXPECT_EQ(mapper.insert(reading(3, 50, 1, -40)), Insertion::kTooManyReadings);
  EXPECT_EQ(mapper.geometry(), geometry);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(mapper.insert(Contact{i, {1, 1}}), Insertion::kAccepted);
  }
  EXPECT_EQ(mapper.insert(Contact{3, {1, 1}}), Insertion::kTooManyReadings);
  EXPECT_EQ(mapper.rejections().count.at(Insertion::kTooManyReadings), 2U);
  EXPECT_EQ(mapper.readings().size(), 2U);
}

TEST(Mapper, SaysWhyForEachReason) {
  for (const Insertion reason :
       {Insertion::kAccepted, Insertion::kPositionNotFinite, Insertion::kPositionTooFar,
        Insertion::kRssiNotFinite, Insertion::kRssiOutOfRange, Insertion::kUnknownAccessPoint,
        Insertion::kTooManyReadings}) {
    EXPECT_STRNE(toString(reason), "");
  }
}

TEST(Mapper, RefusesSettingsAndTablesThatItCannotUse) {
  Config broken;
  broken.map.resolution = kNaN;
  EXPECT_THROW(Mapper(broken, {accessPoint(1, 0, 0)}), InputError);
  EXPECT_THROW(Mapper(Config(), {}), InputError);
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
