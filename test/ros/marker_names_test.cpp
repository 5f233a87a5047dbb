// Names beside access points in rviz: they must not cover the map, or one another.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "ros/conversion/markers.h"

namespace sfw {
namespace {

using Markers = std::vector<visualization_msgs::Marker>;

/// Access points in rows of ten.
Snapshot snapshotOf(int count, double distance_m) {
  const BeliefMap belief(GridGeometry(0.1, {0.0, 0.0}, 300, 300), {});
  Snapshot snapshot{belief, belief, {}, {}, {}};
  for (int i = 0; i < count; ++i) {
    char bssid[18];
    std::snprintf(bssid, sizeof bssid, "02:00:00:00:01:%02x", i);
    AccessPointSummary summary;
    summary.access_point.bssid = *Bssid::parse(bssid);
    summary.access_point.position = distance_m * Position(i % 10, i / 10);
    summary.access_point.position_known = true;
    snapshot.access_points.push_back(summary);
  }
  return snapshot;
}

Markers namesOf(const Snapshot& snapshot, const DataFindings& findings = {}) {
  Markers names;
  for (const auto& marker : toMarkers(snapshot, findings, std_msgs::Header()).markers) {
    if (marker.ns == "names") {
      names.push_back(marker);
    }
  }
  return names;
}

/// Whether one line of text covers another one, if letters are 0.6 as wide as high.
bool covers(const visualization_msgs::Marker& a, const visualization_msgs::Marker& b) {
  const double width = 0.3 * (a.scale.z * static_cast<double>(a.text.size()) +
                              b.scale.z * static_cast<double>(b.text.size()));
  return std::abs(a.pose.position.x - b.pose.position.x) < width &&
         std::abs(a.pose.position.y - b.pose.position.y) < 0.5 * (a.scale.z + b.scale.z);
}

TEST(MarkerNames, AFewAccessPointsHaveWholeAddresses) {
  const Markers names = namesOf(snapshotOf(12, 0.1));
  ASSERT_EQ(names.size(), 12U);
  EXPECT_EQ(names[3].text, "02:00:00:00:01:03");
}

TEST(Markers, ShowAGivenPositionBesideTheEstimateFromIt) {
  Snapshot snapshot = snapshotOf(2, 3.0);
  AccessPointSummary& about = snapshot.access_points[1];
  about.access_point.position_sd_m = 1.0;
  about.given_position = Position(4.0, 0.5);
  about.estimate.emplace();
  about.estimate->position = about.access_point.position;
  about.estimate->covariance = 0.25 * Eigen::Matrix2d::Identity();
  std::vector<visualization_msgs::Marker> given;
  for (const auto& marker : toMarkers(snapshot, {}, std_msgs::Header()).markers) {
    if (marker.ns == "given") {
      given.push_back(marker);
    }
  }
  ASSERT_EQ(given.size(), 1U);
  EXPECT_EQ(given[0].id, 1);
  ASSERT_EQ(given[0].points.size(), 2U);
  EXPECT_EQ(given[0].points[0].x, 4.0);
  EXPECT_EQ(given[0].points[1].x, 3.0);
}

TEST(MarkerNames, FiftyWithRoomAreAllThereAndShort) {
  const Markers names = namesOf(snapshotOf(50, 2.0));
  ASSERT_EQ(names.size(), 50U);
  EXPECT_EQ(names[49].text, "..01:31");
}

TEST(MarkerNames, FiftyInARoomDoNotCoverOneAnother) {
  const Markers names = namesOf(snapshotOf(50, 0.5));
  EXPECT_GT(names.size(), 10U);
  EXPECT_LT(names.size(), 50U);
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (std::size_t j = i + 1; j < names.size(); ++j) {
      EXPECT_FALSE(covers(names[i], names[j])) << names[i].text << " and " << names[j].text;
    }
  }
}

TEST(MarkerNames, SuspectAccessPointsKeepTheirNames) {
  const Snapshot snapshot = snapshotOf(50, 0.5);
  DataFindings findings;
  findings.fits.resize(50);
  findings.fits[1].emplace();  // its neighbour comes first and would take its room
  findings.fits[1]->suspect = true;
  const Markers names = namesOf(snapshot, findings);
  EXPECT_TRUE(std::any_of(names.begin(), names.end(),
                          [](const auto& name) { return name.text == "..01:01"; }));
  EXPECT_FALSE(std::any_of(names.begin(), names.end(),
                           [](const auto& name) { return name.text == "..01:00"; }));
}

}  // namespace
}  // namespace sfw
