#include "output/map_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include "support/png_colours.h"

namespace sfw {
namespace {

/// A big-endian number of a PNG's header.
std::uint32_t number(const std::string& png, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value = value << 8 | static_cast<unsigned char>(png.at(at + i));
  }
  return value;
}

struct Size {
  std::uint32_t width;
  std::uint32_t height;
};

/// The size that a PNG's header tells, after its signature and its end are checked.
Size sizeOf(const std::string& png) {
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(png.substr(12, 4), "IHDR");
  EXPECT_EQ(png.substr(png.size() - 8, 4), "IEND");
  return {number(png, 16), number(png, 20)};
}

/// A map of `width` x `height` m, all free, with an access point in a corner.
Snapshot snapshot(double width, double height, const std::string& name = "router") {
  AccessPoint access_point;
  access_point.bssid = *Bssid::parse("02:00:00:00:00:01");
  access_point.name = name;
  const GridGeometry geometry(0.1, {0, 0}, std::lround(width / 0.1), std::lround(height / 0.1));
  return {BeliefMap(Grid<float>(geometry, 0.1F), {}),
          BeliefMap(Grid<float>(geometry, 0.1F), {}),
          {{0, {0.5, 0.5}, 0}, {1, {0.6, 0.5}, PathPose::kNoWallCount}, {2, {0.7, 0.5}, 9}},
          {{access_point, 0, WallCountClusters{}}},
          {}};
}

TEST(MapPicture, IsAPngWhoseLongSideFillsTheMap) {
  const Size wide = sizeOf(renderPicture(snapshot(16.0, 4.0)));
  EXPECT_NEAR(wide.width, 1080, 2);  // 1000 and two borders of 40
  // Half a metre about the access point at the origin and the farthest cell's centre.
  EXPECT_NEAR(wide.height, 1000.0 * 4.95 / 16.95 + 80 + 56, 2);
  const Size high = sizeOf(renderPicture(snapshot(4.0, 16.0)));
  EXPECT_NEAR(high.height, 1000 + 80 + 56, 2);
  EXPECT_GE(high.width, 520U);  // the footer's
}

TEST(MapPicture, LeavesOutAccessPointsOfUncertainPlace) {
  Snapshot map = snapshot(16.0, 4.0);
  const std::string without = renderPicture(map);
  AccessPointSummary far;
  far.access_point.bssid = *Bssid::parse("02:00:00:00:00:02");
  far.access_point.position = {8.0, 60.0};
  far.access_point.position_known = false;
  far.estimate.emplace();
  far.estimate->covariance = 25.0 * Eigen::Matrix2d::Identity();
  map.access_points.push_back(far);
  EXPECT_TRUE(renderPicture(map) == without);
  map.access_points.back().estimate->covariance = Eigen::Matrix2d::Identity();
  EXPECT_FALSE(renderPicture(map) == without);
}

TEST(MapPicture, IsTheSameForTheSameMap) {
  EXPECT_EQ(renderPicture(snapshot(5.0, 5.0)), renderPicture(snapshot(5.0, 5.0)));
  EXPECT_NE(renderPicture(snapshot(5.0, 5.0)), renderPicture(snapshot(5.0, 5.0, "other")));
}

TEST(MapPicture, TakesAnEmptyMap) {
  Snapshot empty = snapshot(5.0, 5.0);
  empty.belief = BeliefMap(GridGeometry(0.1, {0, 0}, 50, 50), {});
  empty.path.clear();
  sizeOf(renderPicture(empty));
}

TEST(MapPicture, TakesAnyName) {
  for (const std::string& name : {std::string(2000, 'w'), std::string("caf\xe9"), std::string(),
                                  std::string("line\nbreak")}) {
    sizeOf(renderPicture(snapshot(5.0, 5.0, name)));
  }
}

TEST(MapPicture, ShowsItsFooterWhateverAnAccessPointIsCalled) {
  // A text that is no UTF-8 makes Cairo ignore all that follows. Counts of 8 and 9 have one colour
  // on the path, so that only the legend in the footer can tell them apart.
  Snapshot one = snapshot(5.0, 5.0, "caf\xe9");
  Snapshot other = one;
  other.path.back().walls = 8;
  EXPECT_NE(renderPicture(one), renderPicture(other));
}

TEST(MapPicture, ShowsStatesAlone) {
  Grid<CellState> states(GridGeometry(0.1, {0, 0}, 160, 40), CellState::kFree);
  const std::string open = renderPicture(states, {1.0, 1.0});
  EXPECT_NEAR(sizeOf(open).height, 250 + 80 + 56, 2);
  states[{80, 20}] = CellState::kOccupied;
  EXPECT_NE(renderPicture(states, {1.0, 1.0}), open);
  EXPECT_NEAR(sizeOf(renderPicture(states, {-15.99, 1.0})).height, 125 + 80 + 56, 2);
}

using Rgb = std::array<int, 3>;

/// Pixels of a picture for whose colour a rule holds.
template <class Rule>
int pixelsWith(const std::string& png, Rule&& rule) {
  int pixels = 0;
  for (const auto& [colour, count] : test::coloursOf(png)) {
    const auto part = [seen = colour](int shift) { return static_cast<int>(seen >> shift & 0xff); };
    pixels += rule(Rgb{part(16), part(8), part(0)}) ? count : 0;
  }
  return pixels;
}

TEST(MapPicture, DrawsSureWallsDarkerThanUnsureOnes) {
  const std::string none = renderPicture(snapshot(5.0, 5.0));
  Snapshot walls = snapshot(5.0, 5.0);
  const auto dark_red = [](const Rgb& p) { return p[0] > p[1] + 100 && p[1] < 40; };
  const auto pale_red = [](const Rgb& p) { return p[0] > p[1] + 60 && p[1] > 90 && p[1] == p[2]; };
  walls.walls = {{{1.0, 4.0}, {4.0, 4.0}, 0.99}};
  const std::string sure = renderPicture(walls);
  walls.walls[0].confidence = 0.5;
  const std::string unsure = renderPicture(walls);
  constexpr int kMany = 1000;  // more than a legend has
  EXPECT_GT(pixelsWith(sure, dark_red), pixelsWith(none, dark_red) + kMany);
  EXPECT_LT(pixelsWith(unsure, dark_red), pixelsWith(none, dark_red) + kMany);
  EXPECT_GT(pixelsWith(unsure, pale_red), pixelsWith(sure, pale_red) + kMany);
}

/// A snapshot with the same loss in all cells.
Snapshot withLoss(float loss_db) {
  Snapshot result = snapshot(5.0, 5.0);
  TomographySummary tomography{Grid<float>(result.belief.geometry(), loss_db)};
  result.tomography = tomography;
  return result;
}

const auto kLight = [](const Rgb& p) { return p[0] + p[1] + p[2] > 3 * 240; };

TEST(MapPicture, ShadesCellsThatTakeSignalsAway) {
  constexpr int kMany = 100000;  // of about 1000 x 1000
  EXPECT_GT(pixelsWith(renderPicture(withLoss(0.0F)), kLight),
            pixelsWith(renderPicture(withLoss(1.0F)), kLight) + kMany);
}

TEST(WallLossPicture, IsLightWithoutLossAndDarkerWithMore) {
  constexpr int kMany = 100000;
  const auto picture = [](float loss_db) {
    const Snapshot snapshot = withLoss(loss_db);
    return renderWallLoss(snapshot.tomography->wall_loss, snapshot);
  };
  EXPECT_GT(pixelsWith(picture(0.0F), kLight), pixelsWith(picture(0.5F), kLight) + kMany);
  const auto dark = [](const Rgb& p) { return p[2] < 100; };
  EXPECT_GT(pixelsWith(picture(2.0F), dark), pixelsWith(picture(0.5F), dark) + kMany);
  EXPECT_EQ(picture(3.0F), picture(2.0F));
}

TEST(MapPicture, ShowsWhereTheMapLies) {
  // The numbers of the axes tell maps apart that differ by their place only.
  Snapshot here = snapshot(5.0, 5.0);
  Snapshot there = here;
  const Position shift(3.0, 0.0);
  for (PathPose& pose : there.path) {
    pose.antenna_in_map += shift;
  }
  there.access_points[0].access_point.position += shift;
  there.belief = BeliefMap(Grid<float>(GridGeometry(0.1, shift, 50, 50), 0.1F), {});
  EXPECT_NE(renderPicture(here), renderPicture(there));
}

TEST(WallCountColour, IsAsInThePaperForTheFirstCounts) {
  const auto strongest = [](int walls) {
    const Colour colour = wallCountColour(walls);
    return std::max_element(colour.begin(), colour.end()) - colour.begin();
  };
  EXPECT_EQ(strongest(0), 0);  // red
  EXPECT_EQ(strongest(1), 1);  // green
  EXPECT_EQ(strongest(2), 2);  // blue
  const Colour yellow = wallCountColour(3);
  EXPECT_GT(yellow[0], 0.7);
  EXPECT_GT(yellow[1], 0.7);
  EXPECT_LT(yellow[2], 0.3);
}

TEST(WallCountColour, DiffersFromCountToCountAndStaysAtTheEndOfItsScale) {
  std::set<Colour> colours;
  for (int walls = 0; walls < 8; ++walls) {
    colours.insert(wallCountColour(walls));
  }
  EXPECT_EQ(colours.size(), 8U);
  EXPECT_EQ(wallCountColour(8), wallCountColour(7));
  EXPECT_EQ(wallCountColour(1000), wallCountColour(7));
}

TEST(WallCountColour, IsGreyWhereNothingWasHeard) {
  const Colour grey = wallCountColour(PathPose::kNoWallCount);
  EXPECT_EQ(grey[0], grey[1]);
  EXPECT_EQ(grey[1], grey[2]);
}

}  // namespace
}  // namespace sfw
