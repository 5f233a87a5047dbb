#include "checks/time_checks.h"

#include <algorithm>
#include <cstddef>

#include "checks/quantile.h"

namespace sfw {
namespace {

double distance(const Position& a, const Position& b) { return (a - b).norm(); }

double seconds(std::int64_t from_ns, std::int64_t to_ns) {
  return 1e-9 * static_cast<double>(to_ns - from_ns);
}

/// Whether a robot cannot have driven this step. No step leads from one robot to another.
bool isTooFast(const PathPose& from, const PathPose& to) {
  constexpr double kFar = 1.0;   // [m]
  constexpr double kFast = 2.0;  // [m/s], a speed that any robot may reach
  const double way = distance(from.antenna_in_map, to.antenna_in_map);
  return from.robot == to.robot && way > kFar && way > kFast * seconds(from.stamp_ns, to.stamp_ns);
}

/// Bursts of one access point.
struct Bursts {
  std::vector<double> periods_s;
  std::vector<double> ways_m;
};

/// @param readings  of one access point by one robot
Bursts burstsOf(const ReadingRefs& readings) {
  constexpr std::size_t kFewestReadings = 20;
  constexpr double kAtOnce = 0.05;     // [s]
  constexpr double kOfUsual = 0.25;    // of the mean time between readings
  constexpr double kMostAtOnce = 0.6;  // of the readings
  Bursts bursts;
  if (readings.size() < kFewestReadings) {
    return bursts;
  }
  const auto steps = static_cast<double>(readings.size() - 1);
  const double mean =
      seconds(readings.front().get().stamp_ns, readings.back().get().stamp_ns) / steps;
  const auto isAtOnce = [&](std::size_t i) {  // with the reading before
    const double time = seconds(readings[i - 1].get().stamp_ns, readings[i].get().stamp_ns);
    return time <= std::min(kAtOnce, kOfUsual * mean);
  };
  std::size_t at_once = 0;
  for (std::size_t i = 1; i < readings.size(); ++i) {
    at_once += isAtOnce(i) ? 1 : 0;
  }
  if (static_cast<double>(at_once) < kMostAtOnce * steps) {
    return bursts;
  }
  std::size_t first = 0;  // of the burst
  for (std::size_t i = 1; i < readings.size(); ++i) {
    if (!isAtOnce(i)) {
      const Reading& before = readings[i - 1];
      const Reading& reading = readings[i];
      bursts.periods_s.push_back(seconds(readings[first].get().stamp_ns, reading.stamp_ns));
      bursts.ways_m.push_back(distance(before.antenna_in_map, reading.antenna_in_map));
      first = i;
    }
  }
  return bursts;
}

}  // namespace

std::optional<OverlapFinding> checkOverlap(const std::vector<PathPose>& poses,
                                           std::int64_t step_back_ns) {
  constexpr std::size_t kFewestTimes = 8;
  constexpr double kManyOfTheFast = 0.3;
  constexpr double kBack = 0.5;           // of the step away
  constexpr double kLeastStepBack = 1.0;  // [s]
  OverlapFinding finding;
  std::size_t fast = 0;
  for (std::size_t i = 1; i + 1 < poses.size(); ++i) {
    if (!isTooFast(poses[i - 1], poses[i])) {
      continue;
    }
    ++fast;
    const double away = distance(poses[i - 1].antenna_in_map, poses[i].antenna_in_map);
    if (isTooFast(poses[i], poses[i + 1]) &&
        distance(poses[i - 1].antenna_in_map, poses[i + 1].antenna_in_map) < kBack * away) {
      finding.first_stamp_ns = finding.times == 0 ? poses[i].stamp_ns : finding.first_stamp_ns;
      ++finding.times;
      finding.farthest_m = std::max(finding.farthest_m, away);
    }
  }
  if (finding.times < kFewestTimes ||
      static_cast<double>(finding.times) < kManyOfTheFast * static_cast<double>(fast)) {
    return std::nullopt;
  }
  const double step_back = seconds(0, step_back_ns);
  finding.step_back_s = step_back >= kLeastStepBack ? step_back : 0.0;
  return finding;
}

std::optional<BurstFinding> checkBursts(const std::vector<ReadingRefs>& readings) {
  constexpr double kFarApart = 0.5;  // [m]
  Bursts all;
  std::size_t in_bursts = 0;
  std::size_t examined = 0;
  for (const ReadingRefs& radio : readings) {
    for (auto begin = radio.begin(); begin != radio.end();) {
      const auto end = std::find_if(
          begin, radio.end(), [&](const Reading& one) { return one.robot != begin->get().robot; });
      const ReadingRefs one_robot(begin, end);
      const Bursts bursts = burstsOf(one_robot);
      all.periods_s.insert(all.periods_s.end(), bursts.periods_s.begin(), bursts.periods_s.end());
      all.ways_m.insert(all.ways_m.end(), bursts.ways_m.begin(), bursts.ways_m.end());
      in_bursts += bursts.ways_m.empty() ? 0 : one_robot.size();
      examined += one_robot.size();
      begin = end;
    }
  }
  const double way = quantile(all.ways_m, 0.5);
  if (2 * in_bursts < examined || way < kFarApart) {
    return std::nullopt;
  }
  return BurstFinding{static_cast<double>(in_bursts) / static_cast<double>(all.ways_m.size()),
                      quantile(all.periods_s, 0.5), way};
}

std::optional<GapFinding> checkGaps(const std::vector<PathPose>& path, double max_gap_m) {
  constexpr std::size_t kFewestSteps = 5;
  constexpr double kMuch = 0.25;  // of the way
  std::vector<double> gaps;
  double way = 0.0;
  double too_long = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (path[i].robot != path[i - 1].robot) {
      continue;
    }
    const double step = distance(path[i - 1].antenna_in_map, path[i].antenna_in_map);
    way += step;
    if (step > max_gap_m) {
      gaps.push_back(step);
      too_long += step;
    }
  }
  if (gaps.size() < kFewestSteps || too_long < kMuch * way) {
    return std::nullopt;
  }
  return GapFinding{gaps.size(), too_long / way, quantile(gaps, 0.5), max_gap_m};
}

}  // namespace sfw
