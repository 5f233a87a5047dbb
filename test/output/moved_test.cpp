#include "output/moved.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "grid/for_each_cell.h"
#include "output/report.h"
#include "structure_from_wifi/map_notes.h"
#include "support/mapper_scene.h"

namespace sfw {
namespace {

const Position kFar(691000.0, 5334000.0);

/// A short drive past an access point whose position is estimated.
std::shared_ptr<const Snapshot> drive(Mapper& mapper) {
  for (int i = 0; i < 400; ++i) {
    const Position at(0.1 * (i / 80 % 2 == 0 ? i % 80 : 80 - i % 80), i / 80);
    const double distance = std::max(0.3, (at - Position(2.0, 1.5)).norm());
    mapper.insert(test::reading(i, at.x(), at.y(), -40.0 - 20.0 * std::log10(distance)));
  }
  return mapper.infer();
}

TEST(Moved, HasTheSameCellsElsewhere) {
  const Config config;  // tomography, which has wall losses
  AccessPoint access_point = test::accessPoint(1, 0.0, 0.0);
  access_point.position_known = false;
  Mapper mapper(config, {access_point});
  const auto near = drive(mapper);
  ASSERT_TRUE(near->access_points[0].estimate);
  const Snapshot far = moved(*near, kFar);

  EXPECT_EQ(far.offset, kFar);
  const GridGeometry& geometry = near->belief.geometry();
  EXPECT_EQ(far.belief.geometry().origin(), geometry.origin() + kFar);
  EXPECT_EQ(far.probability.geometry(), far.belief.geometry());
  forEachCell(geometry, [&](Cell c) {
    ASSERT_EQ(far.belief.state(c), near->belief.state(c));
    ASSERT_EQ(far.probability.occupied(c), near->probability.occupied(c));
  });
  EXPECT_EQ(far.path[7].antenna_in_map, near->path[7].antenna_in_map + kFar);
  EXPECT_EQ(far.extent.min(), near->extent.min() + kFar);
  const AccessPointSummary& before = near->access_points[0];
  const AccessPointSummary& after = far.access_points[0];
  EXPECT_EQ(after.access_point.position, before.access_point.position + kFar);
  EXPECT_EQ(after.estimate->position, before.estimate->position + kFar);
  EXPECT_EQ(after.samples[3].antenna_in_map, before.samples[3].antenna_in_map + kFar);
  ASSERT_TRUE(near->tomography);
  EXPECT_EQ(far.tomography->wall_loss.geometry, far.belief.geometry());
}

TEST(Moved, MovesAGivenPositionBesideItsEstimate) {
  AccessPoint access_point = test::accessPoint(1, 2.5, 1.5);
  access_point.position_sd_m = 1.0;
  Mapper mapper(test::rawConfig(), {access_point});
  const auto near = drive(mapper);
  const Snapshot far = moved(*near, kFar);
  EXPECT_EQ(far.access_points[0].given_position, Position(Position(2.5, 1.5) + kFar));
  EXPECT_EQ(far.access_points[0].access_point.position,
            near->access_points[0].access_point.position + kFar);
}

TEST(Moved, TellsItsOffsetOnce) {
  const Config config = test::rawConfig();
  Mapper mapper(config, {test::accessPoint(1, 2.0, 1.5)});
  const auto near = drive(mapper);
  const Snapshot far = moved(*near, kFar);
  const std::size_t others = mapNotes(*near).size();
  const std::vector<MapNote> notes = mapNotes(far);
  ASSERT_EQ(notes.size(), others + 1);
  EXPECT_NE(notes.back().text.find("an offset of (691000, 5334000) m"), std::string::npos)
      << notes.back().text;
  EXPECT_NE(reportJson(far, config, {}).find("\"offset\""), std::string::npos);
  EXPECT_EQ(reportJson(*near, config, {}).find("\"offset\""), std::string::npos);
}

TEST(Moved, FindingsMoveAlong) {
  DataFindings findings;
  findings.fits.emplace_back(AccessPointFit());
  findings.fits.emplace_back();
  findings.fits[0]->estimate.position = Position(1.0, 2.0);
  EXPECT_EQ(moved(findings, kFar).fits[0]->estimate.position, kFar + Position(1.0, 2.0));
}

}  // namespace
}  // namespace sfw
