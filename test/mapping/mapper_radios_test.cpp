// Radios instead of BSSIDs, and maps without a table of access points.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/random.h"
#include "simulation/radio/random_field.h"
#include "support/mapper_scene.h"

namespace sfw {
namespace {

using namespace test;

constexpr int kPoses = 400;

/// Through a hall of 8 x 6 m in lanes 1 m apart.
Position poseAt(int i) {
  const int lane = i / 60;
  const double along = 0.133 * (i % 60);
  return {lane % 2 == 0 ? along : 8.0 - along, 1.0 * lane};
}

/// The readings of one radio under several BSSIDs, the first one at its full strength.
/// @param radio  its number, for its fading
std::vector<Reading> heard(const Position& at, std::uint64_t radio,
                           const std::vector<int>& numbers) {
  const RandomField fading(RandomField::Kind::kRough, 0.6, 21, radio);
  std::vector<Reading> readings;
  for (const int number : numbers) {
    Random noise(3, number, 4);
    for (int i = 0; i < kPoses; ++i) {
      const Position place = poseAt(i);
      const double distance = std::hypot((place - at).norm(), 1.0);
      const double offset_db = number == numbers.front() ? 0.0 : 3.0;
      readings.push_back(reading(i, place.x(), place.y(),
                                 std::round(-38.0 - 20.0 * std::log10(distance) - offset_db +
                                            1.5 * fading.at(place) + noise.normal()),
                                 number));
    }
  }
  return readings;
}

std::vector<Reading> together(std::vector<Reading> a, const std::vector<Reading>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const Position kLeft(2.0, 2.5);
const Position kRight(6.5, 4.5);

/// Two radios, the first one under three BSSIDs.
std::vector<Reading> twoRadios() {
  return together(heard(kLeft, 1, {0x21, 0x22, 0x23}), heard(kRight, 2, {0x51}));
}

Mapper mapperOf(const std::vector<AccessPoint>& table, const std::vector<Reading>& readings) {
  Mapper mapper(Config(), table);
  for (const Reading& one : readings) {
    mapper.insert(one);
  }
  return mapper;
}

AccessPoint unplaced(int number) {
  AccessPoint access_point;
  access_point.bssid = bssid(number);
  access_point.position_known = false;
  return access_point;
}

TEST(MapperRadios, JoinTheReadingsOfOneRadio) {
  const auto snapshot =
      mapperOf({unplaced(0x21), unplaced(0x22), unplaced(0x23), unplaced(0x51)}, twoRadios())
          .infer();
  const auto& found = snapshot->access_points;
  EXPECT_EQ(snapshot->recording.aliases.groups,
            (std::vector<std::vector<Bssid>>{{bssid(0x21), bssid(0x22), bssid(0x23)}}));
  EXPECT_FALSE(found[0].radio);
  EXPECT_EQ(found[1].radio, bssid(0x21));
  EXPECT_EQ(found[2].radio, bssid(0x21));
  EXPECT_FALSE(found[3].radio);
  EXPECT_EQ(found[1].readings, static_cast<std::size_t>(kPoses));
  EXPECT_TRUE(found[1].samples.empty());
  ASSERT_EQ(found[0].samples.size(), static_cast<std::size_t>(kPoses));
  ASSERT_TRUE(found[0].estimate);
  EXPECT_EQ(found[1].access_point.position, found[0].estimate->position);
  EXPECT_LT((found[0].estimate->position - kLeft).norm(), 1.0);
}

TEST(MapperRadios, HaveTheMeanOfTheirSignals) {
  const std::vector<Reading> readings = heard(kLeft, 1, {0x21, 0x22});
  const auto snapshot = mapperOf({accessPoint(0x21, 2.0, 2.5), unplaced(0x22)}, readings).infer();
  const auto& samples = snapshot->access_points[0].samples;
  ASSERT_EQ(samples.size(), static_cast<std::size_t>(kPoses));
  for (int i = 0; i < kPoses; ++i) {
    const auto at = static_cast<std::size_t>(i);
    // The second one is 3 dB weaker.
    const double mean = 0.5 * (readings[at].rssi_dbm + readings[at + kPoses].rssi_dbm + 3.0);
    EXPECT_NEAR(samples[at].rssi_dbm, mean, 1e-9);
  }
}

TEST(MapperRadios, TakeThePositionThatTheTableGives) {
  const auto snapshot =
      mapperOf({unplaced(0x21), accessPoint(0x22, 2.0, 2.5)}, heard(kLeft, 1, {0x21, 0x22}))
          .infer();
  EXPECT_EQ(snapshot->access_points[0].radio, bssid(0x22));
  EXPECT_EQ(snapshot->access_points[0].access_point.position, kLeft);
  EXPECT_FALSE(snapshot->access_points[0].estimate);
}

/// An access point whose given position has a standard deviation.
AccessPoint about(int number, double x, double y, double sd_m) {
  AccessPoint access_point = accessPoint(number, x, y);
  access_point.position_sd_m = sd_m;
  return access_point;
}

TEST(MapperRadios, MoveAGivenPositionWithADeviationTowardsTheReadings) {
  const std::vector<Reading> readings = heard(kLeft, 1, {0x21});
  const Position given = kLeft + Position(2.0, 0.0);
  const auto snapshot = mapperOf({about(0x21, given.x(), given.y(), 3.0)}, readings).infer();
  const AccessPointSummary& found = snapshot->access_points[0];
  ASSERT_TRUE(found.estimate);
  EXPECT_EQ(found.given_position, given);
  EXPECT_EQ(found.access_point.position, found.estimate->position);
  EXPECT_LT((found.access_point.position - kLeft).norm(), 1.0);
  EXPECT_TRUE(found.access_point.position_known);
}

TEST(MapperRadios, PreferTheGivenPositionThatIsKnownBest) {
  const std::vector<AccessPoint> table{about(0x21, 3.5, 2.5, 2.0), accessPoint(0x22, 2.0, 2.5)};
  const auto snapshot = mapperOf(table, heard(kLeft, 1, {0x21, 0x22})).infer();
  EXPECT_EQ(snapshot->access_points[0].radio, bssid(0x22))
      << "1.5 m apart, but within two deviations of one";
  EXPECT_EQ(snapshot->access_points[0].access_point.position, kLeft);
  EXPECT_FALSE(snapshot->access_points[0].given_position);
}

TEST(MapperRadios, AreLeftOutIfAWidePriorMeetsTooFewReadings) {
  const auto snapshot =
      mapperOf({about(0x21, 2.0, 2.5, 5.0)}, {reading(0, 1.0, 1.0, -50.0, 0x21)}).infer();
  const AccessPointSummary& found = snapshot->access_points[0];
  ASSERT_TRUE(found.estimate);
  EXPECT_EQ(found.access_point.position, Position(2.0, 2.5));
  EXPECT_FALSE(isPlaced(found));
}

TEST(MapperRadios, GiveTheMapOfOneBssidWithTheirMean) {
  const std::vector<AccessPoint> table{accessPoint(0x21, 2.0, 2.5), accessPoint(0x22, 2.0, 2.5)};
  const auto both = mapperOf(table, heard(kLeft, 1, {0x21, 0x22})).infer();
  std::vector<Reading> mean;
  for (std::size_t i = 0; i < both->access_points[0].samples.size(); ++i) {
    const Sample& sample = both->access_points[0].samples[i];
    mean.push_back(reading(static_cast<std::int64_t>(i), sample.antenna_in_map.x(),
                           sample.antenna_in_map.y(), sample.rssi_dbm, 0x21));
  }
  const auto one = mapperOf({table[0]}, mean).infer();
  EXPECT_TRUE(probabilityPgm(both->probability) == probabilityPgm(one->probability));
}

TEST(MapperWithoutTable, PlacesAllThatAreHeard) {
  Mapper mapper = mapperOf({}, twoRadios());
  EXPECT_EQ(mapper.accessPoints().size(), 4U);
  const auto snapshot = mapper.infer();
  EXPECT_FALSE(snapshot->has_table);
  EXPECT_TRUE(snapshot->rejections.count.empty());
  const auto& found = snapshot->access_points;
  ASSERT_EQ(found.size(), 4U);
  ASSERT_TRUE(found[0].estimate);
  ASSERT_TRUE(found[3].estimate);
  EXPECT_LT((found[0].estimate->position - kLeft).norm(), 1.0);
  EXPECT_LT((found[3].estimate->position - kRight).norm(), 1.0);
  EXPECT_EQ(found[3].heard, static_cast<std::size_t>(kPoses));
}

TEST(MapperWithoutTable, GivesTheSameMapInAnyOrder) {
  std::vector<Reading> readings = twoRadios();
  const std::uint64_t sorted = hashOf(mapperOf({}, readings));
  std::mt19937 random(8);
  std::shuffle(readings.begin(), readings.end(), random);
  EXPECT_EQ(hashOf(mapperOf({}, readings)), sorted);
}

TEST(MapperWithoutTable, IsTheMapOfATableThatListsAll) {
  const auto with =
      mapperOf({unplaced(0x21), unplaced(0x22), unplaced(0x23), unplaced(0x51)}, twoRadios())
          .infer();
  const auto without = mapperOf({}, twoRadios()).infer();
  EXPECT_TRUE(trinaryPgm(with->belief) == trinaryPgm(without->belief));
  EXPECT_TRUE(with->has_table);
}

TEST(MapperWithoutTable, StartsUnknownAtTheOrigin) {
  const Mapper mapper(Config(), {});
  EXPECT_TRUE(mapper.geometry().contains(mapper.geometry().cellAt(Position::Zero())));
  EXPECT_TRUE(mapper.infer()->access_points.empty());
}

TEST(MapperWithoutTable, ForgetsWhatItHeardOnReset) {
  Mapper mapper = mapperOf({}, twoRadios());
  mapper.setAccessPoints({accessPoint(0x51, 6.5, 4.5), unplaced(0x21)});
  mapper.reset();
  ASSERT_EQ(mapper.accessPoints().size(), 1U);  // somebody placed it
  EXPECT_EQ(mapper.accessPoints()[0].bssid, bssid(0x51));
  EXPECT_EQ(mapper.insert(reading(1, 1.0, 1.0, -50.0, 0x22)), InsertResult::kAccepted);
  EXPECT_EQ(mapper.accessPoints()[0].bssid, bssid(0x22));
}

TEST(MapperWithoutTable, StopsAtTwoThousand) {
  Mapper mapper(Config(), {});
  for (int i = 1; i <= 2000; ++i) {
    char address[18];
    std::snprintf(address, sizeof address, "02:00:00:00:%02x:%02x", i / 256, i % 256);
    Reading one = reading(i, 1.0, 1.0, -50.0);
    one.bssid = *Bssid::parse(address);
    ASSERT_EQ(mapper.insert(one), InsertResult::kAccepted);
  }
  Reading another = reading(3000, 1.0, 1.0, -50.0);
  another.bssid = *Bssid::parse("aa:00:00:00:00:01");
  EXPECT_EQ(mapper.insert(another), InsertResult::kUnknownAccessPoint);
}

TEST(MapperWithoutTable, TellsAWrongUnit) {
  std::vector<Reading> readings = twoRadios();
  for (Reading& one : readings) {
    one.rssi_dbm = 2.0 * (one.rssi_dbm + 100.0);  // percent
  }
  EXPECT_TRUE(mapperOf({}, readings).infer()->recording.signal_unit);
}

/// A radio of which only one side of a straight path is known: both sides fit its signals.
TEST(MapperWithoutTable, LeavesOutRadiosOfUncertainPlace) {
  std::vector<Reading> readings;
  Random noise(3, 1, 4);
  for (int i = 0; i < 200; ++i) {
    const Position place(0.1 * i, 0.0);
    const double distance = (place - Position(10.0, 6.0)).norm();
    readings.push_back(
        reading(i, place.x(), 0.0, -40.0 - 20.0 * std::log10(distance) + noise.normal()));
  }
  const auto snapshot = mapperOf({}, readings).infer();
  ASSERT_TRUE(snapshot->access_points[0].estimate);
  EXPECT_TRUE(hasPosition(snapshot->access_points[0]));
  EXPECT_FALSE(isPlaced(snapshot->access_points[0]));
  EXPECT_EQ(snapshot->tomography->explained_variance, 0.0);
}

}  // namespace
}  // namespace sfw
