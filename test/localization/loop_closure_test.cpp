#include "localization/loop_closure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "localization/drifted_hall.h"

namespace sfw {
namespace {

/// Root mean square distance of the scans from their true places.
double errorOf(const DriftedHall& hall, const LoopClosure& loop) {
  const std::vector<Scan> truth = hall.truth();
  const std::vector<Position> odometry = hall.odometry();
  double squares = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    squares += (loop.moved(truth[i].stamp_ns, odometry[i]) - truth[i].position).squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(truth.size()));
}

double errorOf(const DriftedHall& hall) { return errorOf(hall, LoopClosure()); }

TEST(CloseLoops, CorrectsDrift) {
  const DriftedHall hall{0.008};
  ASSERT_GT(errorOf(hall), 3.0);
  const LoopClosure loop = closeLoops(hall.readings(), 0);
  EXPECT_GT(loop.closings, 30U);
  EXPECT_LT(errorOf(hall, loop), 0.8 * errorOf(hall));
  EXPECT_LT(loop.after.distance_m, 0.5 * loop.before.distance_m);
  EXPECT_EQ(loop.finding, LoopClosure::Finding::kDrift);
  EXPECT_GT(loop.farthest_moved_m, 2.0);
}

TEST(CloseLoops, MovesAGoodPathLittle) {
  const DriftedHall hall;
  const LoopClosure loop = closeLoops(hall.readings(), 0);
  EXPECT_GT(loop.closings, 30U);
  EXPECT_LT(errorOf(hall, loop), 0.8);  // what the radio resolves
  EXPECT_EQ(loop.finding, LoopClosure::Finding::kNoDrift);
}

TEST(CloseLoops, FindsNoneWithoutAReturn) {
  std::vector<Reading> readings = DriftedHall{0.008}.readings();
  readings.resize(readings.size() / 2);
  EXPECT_EQ(closeLoops(readings, 0).finding, LoopClosure::Finding::kNoLoop);
  readings.resize(readings.size() / 10);
  EXPECT_EQ(closeLoops(readings, 0).closings, 0U);
  EXPECT_EQ(closeLoops({}, 0).closings, 0U);
}

TEST(CloseLoops, NeedsFourRadios) {
  std::vector<Reading> readings = DriftedHall{0.008}.readings();
  const auto of = [&](std::size_t radios) {
    std::vector<Reading> some;
    for (std::size_t i = 0; i < readings.size(); ++i) {
      if (i % 8 < radios) {  // a scan has eight
        some.push_back(readings[i]);
      }
    }
    return closeLoops(some, 0).finding;
  };
  EXPECT_EQ(of(3), LoopClosure::Finding::kFewRadios);
  EXPECT_NE(of(4), LoopClosure::Finding::kFewRadios);
}

TEST(CloseLoops, DoesNotBelieveSignalsOfOtherTimes) {
  std::vector<Reading> readings = DriftedHall{0.003}.readings();
  std::vector<double> signals;
  for (const Reading& reading : readings) {
    signals.push_back(reading.rssi_dbm);
  }
  const std::size_t later = readings.size() / 24 * 8;  // a third, in whole scans of eight radios
  for (std::size_t i = 0; i < readings.size(); ++i) {
    readings[i].rssi_dbm = signals[(i + later) % readings.size()];
  }
  EXPECT_NE(closeLoops(readings, 0).finding, LoopClosure::Finding::kDrift);
}

TEST(CloseLoops, TakesEachRobotByItselfInAnyOrder) {
  const DriftedHall drifting{0.008};
  std::vector<Reading> readings = drifting.readings();
  for (Reading reading : DriftedHall().readings()) {
    reading.robot = "good";
    readings.push_back(reading);
  }
  std::reverse(readings.begin(), readings.end());
  const auto loops = closeLoopsByRobot(readings, 0);
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_EQ(loops.at("good").finding, LoopClosure::Finding::kNoDrift);
  EXPECT_TRUE(loops.at("").path.positions == closeLoops(drifting.readings(), 0).path.positions);
}

TEST(CloseLoops, StopsWhenAsked) {
  const std::atomic<bool> stop{true};
  EXPECT_EQ(closeLoops(DriftedHall{0.008}.readings(), 0, &stop).closings, 0U);
}

TEST(LoopClosure, MovesAPointWithTheRobotOfItsTime) {
  LoopClosure loop;
  loop.stamps_ns = {10, 20};
  loop.odometry = {{0.0, 0.0}, {1.0, 0.0}};
  loop.path = {{{0.0, 0.0}, {1.0, 2.0}}, {0.0, 0.0}};
  EXPECT_EQ(loop.moved(5, {3.0, 0.0}), Position(3.0, 0.0));
  EXPECT_EQ(loop.moved(15, {3.0, 0.0}), Position(3.0, 1.0));
  EXPECT_EQ(loop.moved(25, {3.0, 0.0}), Position(3.0, 2.0));
  loop.path.turns_rad[1] = 0.5 * kPi;
  EXPECT_NEAR((loop.moved(20, {2.0, 0.0}) - Position(1.0, 3.0)).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace sfw
