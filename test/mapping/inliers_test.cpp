#include "mapping/inliers.h"

#include <gtest/gtest.h>

#include "support/mapper_scene.h"

namespace sfw {
namespace {

const std::map<Bssid, std::size_t> kTable{{test::bssid(1), 0}, {test::bssid(2), 1}};

Inliers inliersOf(const std::vector<Reading>& readings, const std::vector<Contact>& contacts = {}) {
  return withoutStrayPoses(sortedByStamp(readings), contacts, kTable);
}

TEST(Inliers, SortReadingsByAccessPointAndStamp) {
  const Inliers inliers =
      inliersOf({test::reading(2, 0.2, 0.0, -50.0, 2), test::reading(2, 0.2, 0.0, -60.0),
                 test::reading(1, 0.1, 0.0, -70.0), test::reading(3, 0.3, 0.0, -80.0, 9)});
  ASSERT_EQ(inliers.path.size(), 3U);
  ASSERT_EQ(inliers.readings.size(), 2U);
  ASSERT_EQ(inliers.readings[0].samples.size(), 2U);
  EXPECT_EQ(inliers.readings[0].samples[0].rssi_dbm, -70.0);
  EXPECT_EQ(inliers.readings[0].samples[1].rssi_dbm, -60.0);
  EXPECT_EQ(inliers.readings[0].poses, (std::vector<std::uint32_t>{0, 1}));
  ASSERT_EQ(inliers.readings[1].samples.size(), 1U);
  EXPECT_EQ(inliers.readings[1].poses, (std::vector<std::uint32_t>{1}));
}

TEST(Inliers, TakeACachedValueOnce) {
  std::vector<Reading> readings;
  const std::vector<double> values{-50.0, -50.0, -50.0, -60.0, -60.0, -50.0, -50.0};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto at = static_cast<double>(i);
    // The robot stands for the last reading.
    readings.push_back(
        test::reading(static_cast<std::int64_t>(i), 0.2 * std::min(at, 5.0), 0.0, values[i]));
  }
  Inliers inliers = inliersOf(readings);
  removeRepeated(inliers.readings);
  EXPECT_EQ(inliers.path.size(), values.size());
  EXPECT_EQ(inliers.readings[0].poses, (std::vector<std::uint32_t>{0, 3, 5, 6}));
}

TEST(Inliers, LeaveOutStrayPosesWithTheirReadingsAndContacts) {
  std::vector<Reading> readings;
  for (int i = 0; i <= 20; ++i) {
    readings.push_back(test::reading(i, i == 10 ? 30.0 : 0.1 * i, 0.0, -40.0 - i));
  }
  const Inliers inliers =
      inliersOf(readings, {{9'000'000'000, {0.9, 0.2}}, {10'000'000'000, {30.0, 0.2}}});
  EXPECT_EQ(inliers.stray.count, 1U);
  EXPECT_EQ(inliers.stray.first_stamp_ns, 10'000'000'000);
  EXPECT_NEAR(inliers.stray.farthest_m, 29.1, 1e-9);
  EXPECT_EQ(inliers.path.size(), 20U);
  ASSERT_EQ(inliers.readings[0].samples.size(), 20U);
  EXPECT_EQ(inliers.readings[0].samples[10].rssi_dbm, -51.0);
  EXPECT_EQ(inliers.readings[0].poses[10], 10U);
  ASSERT_EQ(inliers.contacts.size(), 1U);
  EXPECT_EQ(inliers.contacts[0].point_in_map, Position(0.9, 0.2));
}

TEST(Inliers, KeepTheStrongestReadingOfARadioAtAStamp) {
  const Inliers inliers =
      inliersOf({test::reading(1, 0.0, 0.0, -60.0), test::reading(1, 0.0, 0.0, -50.0),
                 test::reading(1, 0.5, 0.0, -55.0)});
  ASSERT_EQ(inliers.readings[0].samples.size(), 1U);
  EXPECT_EQ(inliers.readings[0].samples[0].rssi_dbm, -50.0);
  EXPECT_EQ(inliers.stamped_alike, 1U);  // only one was taken at another position
  EXPECT_EQ(inliers.path.size(), 1U);
}

// ---- Contacts that the robot drove over ----

/// A drive along x = 0..2 m, a pose each second.
const std::vector<PathPose> kDrive{
    {0, {0.0, 0.0}, 0}, {1'000'000'000, {1.0, 0.0}, 0}, {2'000'000'000, {2.0, 0.0}, 0}};

std::size_t keptOf(const Contact& contact, double max_gap_m = 1.5) {
  std::vector<Contact> contacts{contact};
  removeDrivenOver(kDrive, 0.1, max_gap_m, contacts);
  return contacts.size();
}

TEST(ContactsDrivenOver, AreRemoved) {
  EXPECT_EQ(keptOf({500'000'000, {1.5, 0.05}}), 0U);  // between two later poses
}

TEST(ContactsDrivenOver, StayBesideThePath) { EXPECT_EQ(keptOf({500'000'000, {1.5, 0.15}}), 1U); }

TEST(ContactsDrivenOver, StayWhereTheRobotDroveBefore) {
  EXPECT_EQ(keptOf({1'500'000'000, {0.5, 0.0}}), 1U);
}

TEST(ContactsDrivenOver, StayInGapsOfThePath) {
  EXPECT_EQ(keptOf({500'000'000, {1.5, 0.0}}, 0.8), 1U);
}

}  // namespace
}  // namespace sfw
