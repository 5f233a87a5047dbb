#include "checks/unit_checks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "checks/quantile.h"

namespace sfw {
namespace {

constexpr std::size_t kFewestSteps = 20;
constexpr double kMoves = 0.01;

/// What the data are, if they are in metres and seconds.
struct Measures {
  double speed = 0.0;     // median of the steps that move
  double interval = 0.0;  // median time between poses
  double extent = 0.0;    // diagonal of the driven area, without its outermost twentieths
  double step = 0.0;      // median length of the steps that move
  std::optional<double> power_dbm;
};

struct Length {
  LengthUnit unit;
  double metres;
};
struct Time {
  TimeUnit unit;
  double seconds;
};

// Pixels of 5 cm, as most maps have; those of 2 to 10 cm are found alike.
constexpr Length kLengths[] = {{LengthUnit::kMetres, 1.0},
                               {LengthUnit::kPixels, 0.05},
                               {LengthUnit::kCentimetres, 0.01},
                               {LengthUnit::kMillimetres, 0.001}};
constexpr Time kTimes[] = {{TimeUnit::kSeconds, 1.0},
                           {TimeUnit::kMilliseconds, 1e-3},
                           {TimeUnit::kMicroseconds, 1e-6},
                           {TimeUnit::kMinutes, 60.0},
                           {TimeUnit::kDays, 86400.0}};

double extentAlong(const std::vector<PathPose>& poses, int axis) {
  std::vector<double> values;
  values.reserve(poses.size());
  for (const PathPose& pose : poses) {
    values.push_back(pose.antenna_in_map[axis]);
  }
  return quantile(values, 0.95) - quantile(values, 0.05);
}

std::optional<Measures> measuresOf(const std::vector<PathPose>& poses) {
  std::vector<double> speeds;
  std::vector<double> intervals;
  std::vector<double> steps;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    if (poses[i].robot != poses[i - 1].robot) {
      continue;
    }
    const double way = (poses[i].antenna_in_map - poses[i - 1].antenna_in_map).norm();
    const double time = 1e-9 * static_cast<double>(poses[i].stamp_ns - poses[i - 1].stamp_ns);
    if (time > 0.0) {
      intervals.push_back(time);
    }
    if (time > 0.0 && way > kMoves) {
      steps.push_back(way);
      speeds.push_back(way / time);
    }
  }
  if (speeds.size() < kFewestSteps) {
    return std::nullopt;
  }
  return Measures{quantile(speeds, 0.5), quantile(intervals, 0.5),
                  std::hypot(extentAlong(poses, 0), extentAlong(poses, 1)), quantile(steps, 0.5),
                  std::nullopt};
}

/// Half of the squared distance to what is usual, in standard deviations of the logarithm.
double surprise(double value, double usual, double factor) {
  const double away = std::log(std::max(value, 1e-12) / usual) / std::log(factor);
  return 0.5 * away * away;
}

/// A negative log likelihood.
double unlikelihood(const Measures& measures, const Length& length, const Time& time) {
  constexpr double kUsualPower = -27.0;  // [dBm] at 1 m, with the luck of the strongest twentieth
  constexpr double kPowerDeviation = 6.0;
  constexpr double kMostOfPower = 8.0;  // a wrong position in the table must not decide alone
  double sum = surprise(measures.speed * length.metres / time.seconds, 0.4, 2.5) +
               surprise(measures.interval * time.seconds, 0.5, 4.0) +
               surprise(measures.extent * length.metres, 12.0, 3.5);
  if (measures.power_dbm) {
    const double power = *measures.power_dbm + 20.0 * std::log10(length.metres);
    const double away = (power - kUsualPower) / kPowerDeviation;
    sum += std::min(kMostOfPower, 0.5 * away * away);
  }
  return sum;
}

}  // namespace

std::optional<UnitFinding> checkUnits(const std::vector<PathPose>& poses,
                                      std::optional<double> power_dbm) {
  constexpr double kFastest = 3.0;    // [m/s], median of a robot or walker in a building
  constexpr double kSlowest = 0.004;  // [m/s]
  constexpr double kSure = 10.0;      // of the log likelihood ratio, without a speed beyond these
  constexpr double kBetter = 3.0;     // likewise, with such a speed
  constexpr double kSmooth = 0.22;    // steps over extent; poses with another one's stamp have 0.4
  std::optional<Measures> measures = measuresOf(poses);
  if (!measures || measures->step > kSmooth * measures->extent) {
    return std::nullopt;
  }
  measures->power_dbm = power_dbm;
  const double as_told = unlikelihood(*measures, kLengths[0], kTimes[0]);
  double least = std::numeric_limits<double>::infinity();
  UnitFinding finding;
  for (const Length& length : kLengths) {
    for (const Time& time : kTimes) {
      const double here = unlikelihood(*measures, length, time);
      if (here < least) {
        least = here;
        finding = {length.unit, time.unit, measures->speed, measures->extent};
      }
    }
  }
  const bool is_odd = measures->speed > kFastest || measures->speed < kSlowest;
  return as_told - least > (is_odd ? kBetter : kSure) ? std::optional(finding) : std::nullopt;
}

std::optional<double> powerAtOneUnit(const std::vector<AccessPoint>& access_points,
                                     const std::vector<ReadingRefs>& readings) {
  constexpr std::size_t kFewestReadings = 50;
  constexpr double kNearest = 0.3;
  constexpr double kBeside = 0.5;  // of the extent: a farther position is wrong, or of another unit
  Box path;
  for (const auto& radio : readings) {
    for (const Reading& reading : radio) {
      path.extend(reading.antenna_in_map);
    }
  }
  if (path.isEmpty()) {
    return std::nullopt;
  }
  const Position margin = Position::Constant(kBeside * path.diagonal().norm());
  const Box near_path(path.min() - margin, path.max() + margin);
  const auto isNear = [&](std::size_t i) {
    return access_points[i].position_known && near_path.contains(access_points[i].position);
  };
  std::size_t count = 0;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    count += isNear(i) ? readings[i].size() : 0;
  }
  std::vector<double> powers;
  powers.reserve(count);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (!isNear(i)) {
      continue;
    }
    for (const Reading& reading : readings[i]) {
      const double distance = (reading.antenna_in_map - access_points[i].position).norm();
      powers.push_back(reading.rssi_dbm + 20.0 * std::log10(std::max(kNearest, distance)));
    }
  }
  return count < kFewestReadings ? std::nullopt : std::optional(quantile(std::move(powers), 0.95));
}

}  // namespace sfw
