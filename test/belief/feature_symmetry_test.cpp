#include <gtest/gtest.h>

#include <functional>
#include <iterator>
#include <random>

#include "radio/path_loss.h"
#include "support/feature_scene.h"

// Every feature stays the same when the world is turned by quarters or mirrored: a building's axes
// are known up to quarter turns only. The four distances along the axes are sorted for that reason.

namespace sfw::test {
namespace {

constexpr std::int64_t kSize = 25;

/// Where a cell of a picture of 25 x 25 cells lies after a move.
using Move = std::function<Cell(Cell)>;

Cell unmoved(Cell c) { return c; }

std::vector<Move> allMoves() {
  const std::int64_t last = kSize - 1;
  return {[=](Cell c) { return Cell{last - c.y, c.x}; },  // a quarter turn
          [=](Cell c) { return Cell{last - c.x, last - c.y}; },  // two
          [=](Cell c) { return Cell{c.y, last - c.x}; },  // three
          [=](Cell c) { return Cell{last - c.x, c.y}; },  // the mirrors
          [=](Cell c) { return Cell{c.x, last - c.y}; },
          [=](Cell c) { return Cell{c.y, c.x}; },
          [=](Cell c) { return Cell{last - c.y, last - c.x}; }};
}

Picture moved(const Picture& picture, const Move& move) {
  const Grid<char> before = gridFrom<char>(picture, 1.0, [](char c) { return c; });
  Grid<char> after(before.geometry);
  for (std::size_t i = 0; i < before.cells.size(); ++i) {
    after[move(before.geometry.cell(i))] = before.cells[i];
  }
  return rowsOf(after, [](char c) { return c; });
}

/// Two bands, so that every cell outside has one nearest cell of the path, in the middle of a field
/// so large that nothing is closed up to its edges.
Picture twoBands() {
  const Picture middle{"abc#gh##...",  //
                       "##def#ij...",  //
                       "...........",  //
                       "...........",  //
                       "........#k#",  //
                       "........##l",  //
                       "........#m#",  //
                       "........n##",  //
                       "...........",  //
                       "...........",  //
                       "..........."};
  const std::string side(7, '.');
  Picture picture(7, std::string(kSize, '.'));
  for (const std::string& row : middle) {
    picture.push_back(side + row + side);
  }
  picture.resize(kSize, std::string(kSize, '.'));
  return picture;
}

/// Walls of 0 to 9 dB anywhere: no two ways to a cell cost the same.
Picture manyWalls() {
  std::mt19937 random(2);
  Picture picture(kSize, std::string(kSize, '0'));
  for (std::string& row : picture) {
    for (char& c : row) {
      c = static_cast<char>('0' + random() % 10);
    }
  }
  return picture;
}

/// An access point that hears along both bands; walls explain a part of its signals.
AccessPointBins slantedRays(const FeatureScene& scene, Cell at, const Move& move,
                            const std::vector<double>& loss_db) {
  const std::vector<Cell> places{{7, 17},  {8, 17},  {10, 17}, {11, 17}, {13, 16}, {14, 16},
                                 {17, 13}, {16, 12}, {17, 12}, {16, 11}, {17, 11}};
  std::vector<Cell> bins;
  std::transform(places.begin(), places.end(), std::back_inserter(bins), move);
  AccessPointBins access_point = accessPointAt(scene, move(at), bins);
  for (std::size_t i = 0; i < bins.size(); ++i) {
    RadioBin& bin = access_point.bins[i];
    const double jitter_db = i % 3 == 0 ? 1.0 : 0.0;
    bin.rssi_dbm = -40.0 - 2.0 * logDistance(access_point, bin.position) - loss_db[i] + jitter_db;
  }
  return access_point;
}

CellFeatures describedAfter(const Move& move) {
  FeatureScene scene{moved(twoBands(), move), 0.4, moved(manyWalls(), move)};
  scene.ray_loss_db = {{1, 2, 4, 0, 6, 1, 3, 2, 1, 0, 5}, {3, 1, 0, 2, 1, 4, 5, 2, 6, 7, 3}};
  scene.access_points = {slantedRays(scene, {8, 9}, move, scene.ray_loss_db[0]),
                         slantedRays(scene, {20, 22}, move, scene.ray_loss_db[1])};
  return described(scene);
}

TEST(FeatureSymmetry, EveryFeatureTurnsAndMirrorsWithTheWorld) {
  const CellFeatures here = describedAfter(unmoved);
  for (const Move& move : allMoves()) {
    const CellFeatures there = describedAfter(move);
    ASSERT_EQ(here.cells.size(), there.cells.size());
    for (const CellFeature& feature : kCellFeatureTable) {
      const char* const name = feature.name;
      const Grid<float> before = featureOf(here, name);
      const Grid<float> after = featureOf(there, name);
      for (const std::size_t i : here.cells) {
        const Cell c = before.geometry.cell(i);
        ASSERT_NEAR(before[c], after[move(c)], 1e-5F) << name << " at " << c.x << ' ' << c.y;
      }
    }
    EXPECT_NEAR(here.style.rim_share, there.style.rim_share, 1e-9);
    EXPECT_NEAR(here.style.axis_share, there.style.axis_share, 1e-9);
    EXPECT_NEAR(here.style.winding, there.style.winding, 1e-9);
  }
}

TEST(FeatureSymmetry, EveryFeatureDiffersBetweenCellsOfTheScene) {
  // Otherwise the test above would say nothing about it.
  const CellFeatures features = describedAfter(unmoved);
  for (const CellFeature& feature : kCellFeatureTable) {
    const std::string name = feature.name;
    const Grid<float> all = featureOf(features, name);
    float least = 1e9F;
    float most = -1e9F;
    for (const std::size_t i : features.cells) {
      least = std::min(least, all.cells[i]);
      most = std::max(most, all.cells[i]);
    }
    if (name == "explained") {
      EXPECT_GT(least, 0.2F) << "one share for the whole drive";
    } else {
      EXPECT_GT(most, least + 0.01F) << name;
    }
  }
}

}  // namespace
}  // namespace sfw::test
