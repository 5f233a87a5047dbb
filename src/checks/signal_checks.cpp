#include "checks/signal_checks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>

#include "checks/quantile.h"

namespace sfw {
namespace {

using Scale = SignalUnitFinding::Scale;
using Readings = ReadingRefs;

/// Whether most signals of an access point are refused, and not for one value alone.
bool isOtherUnit(const Readings& accepted, const Readings& refused) {
  constexpr std::size_t kFewestReadings = 10;
  constexpr std::size_t kFewestValues = 3;
  constexpr double kNearlyAll = 0.8;
  if (refused.size() < kFewestReadings || refused.size() < accepted.size()) {
    return false;
  }
  std::map<double, std::size_t> counts;
  std::size_t most = 0;
  for (const Reading& reading : refused) {
    most = std::max(most, ++counts[reading.rssi_dbm]);
  }
  return counts.size() >= kFewestValues &&
         static_cast<double>(most) < kNearlyAll * static_cast<double>(refused.size());
}

/// Correlation of values with the logarithm of the distance to the access point; 0 if either is
/// constant.
double correlationWithDistance(const Readings& readings, const Position& access_point) {
  constexpr double kNearest = 0.3;
  double mean_value = 0.0;
  double mean_distance = 0.0;
  std::vector<double> distances;
  const auto count = static_cast<double>(readings.size());
  for (const Reading& reading : readings) {
    const double away = (reading.antenna_in_map - access_point).norm();
    distances.push_back(std::log(std::max(kNearest, away)));
    mean_distance += distances.back() / count;
    mean_value += reading.rssi_dbm / count;
  }
  double product = 0.0;
  double value_squares = 0.0;
  double distance_squares = 0.0;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const double value = readings[i].get().rssi_dbm - mean_value;
    const double distance = distances[i] - mean_distance;
    product += value * distance;
    value_squares += value * value;
    distance_squares += distance * distance;
  }
  const double squares = value_squares * distance_squares;
  return squares > 0.0 ? product / std::sqrt(squares) : 0.0;
}

Scale scaleOf(const AccessPoint& access_point, const Readings& refused) {
  constexpr double kMostPercent = 100.0;
  constexpr double kTenths = -1300.0;
  constexpr double kClear = 0.3;
  std::vector<double> values;
  for (const Reading& reading : refused) {
    values.push_back(reading.rssi_dbm);
  }
  const double usual = quantile(values, 0.5);
  if (usual < 0.0) {
    return usual < kTenths ? Scale::kMilliDbm : Scale::kTenths;
  }
  if (usual > kMostPercent) {
    return Scale::kUnsignedByte;
  }
  if (!access_point.position_known) {
    return Scale::kPositive;
  }
  const double correlation = correlationWithDistance(refused, access_point.position);
  return correlation > kClear    ? Scale::kWithoutSign
         : correlation < -kClear ? Scale::kPercent
                                 : Scale::kPositive;
}

/// Signals that follow each other while the robot drives.
struct Repetition {
  std::size_t pairs = 0;
  std::size_t equal = 0;
  double way_m = 0.0;           // of all pairs
  std::vector<double> changes;  // of the others [dB]
};

Repetition repetitionOf(const Readings& readings) {
  constexpr double kDrives = 0.005;  // [m] from one reading to the next
  Repetition repetition;
  for (std::size_t i = 1; i < readings.size(); ++i) {
    const Reading& before = readings[i - 1];
    const Reading& reading = readings[i];
    const double way = (reading.antenna_in_map - before.antenna_in_map).norm();
    if (way < kDrives || reading.robot != before.robot) {
      continue;
    }
    const double change = std::abs(reading.rssi_dbm - before.rssi_dbm);
    ++repetition.pairs;
    repetition.way_m += way;
    if (change > 0.0) {
      repetition.changes.push_back(change);
    } else {
      ++repetition.equal;
    }
  }
  return repetition;
}

bool isCached(const Repetition& repetition) {
  constexpr std::size_t kFewestPairs = 40;
  constexpr std::size_t kFewestChanges = 8;
  constexpr double kEqual = 0.45;
  constexpr double kLarge = 1.8;  // steps of the radio
  if (repetition.pairs < kFewestPairs || repetition.changes.size() < kFewestChanges ||
      static_cast<double>(repetition.equal) < kEqual * static_cast<double>(repetition.pairs)) {
    return false;
  }
  const double step = quantile(repetition.changes, 0.1);
  double sum = 0.0;
  for (const double change : repetition.changes) {
    sum += change;
  }
  return sum > kLarge * step * static_cast<double>(repetition.changes.size());
}

}  // namespace

std::optional<SignalUnitFinding> checkSignalUnit(const std::vector<AccessPoint>& table,
                                                 const std::vector<Readings>& accepted,
                                                 const std::vector<Readings>& refused) {
  SignalUnitFinding finding;
  std::set<Scale> scales;
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (!isOtherUnit(accepted[i], refused[i])) {
      continue;
    }
    scales.insert(scaleOf(table[i], refused[i]));
    const auto [lowest, highest] = std::minmax_element(
        refused[i].begin(), refused[i].end(),
        [](const Reading& a, const Reading& b) { return a.rssi_dbm < b.rssi_dbm; });
    const bool is_first = finding.radios.empty();
    finding.lowest =
        is_first ? lowest->get().rssi_dbm : std::min(finding.lowest, lowest->get().rssi_dbm);
    finding.highest =
        is_first ? highest->get().rssi_dbm : std::max(finding.highest, highest->get().rssi_dbm);
    finding.readings += refused[i].size();
    finding.radios.push_back(table[i].bssid);
  }
  if (finding.radios.empty()) {
    return std::nullopt;
  }
  if (scales.size() > 1) {
    scales.erase(Scale::kPositive);  // others show clearly what it is
  }
  finding.scale = scales.size() == 1 ? *scales.begin() : Scale::kPositive;
  return finding;
}

std::optional<CachedFinding> checkCachedSignals(const std::vector<AccessPoint>& table,
                                                const std::vector<Readings>& readings) {
  constexpr double kManyOfTable = 0.2;
  CachedFinding finding;
  std::size_t examined = 0;
  std::size_t pairs = 0;
  double runs = 0.0;
  double way = 0.0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const Repetition repetition = repetitionOf(readings[i]);
    examined += repetition.changes.empty() ? 0 : 1;
    if (isCached(repetition)) {
      finding.radios.push_back(table[i].bssid);
      pairs += repetition.pairs;
      runs += static_cast<double>(repetition.changes.size());
      way += repetition.way_m;
    }
  }
  if (finding.radios.empty() ||
      static_cast<double>(finding.radios.size()) < kManyOfTable * static_cast<double>(examined)) {
    return std::nullopt;
  }
  finding.readings = static_cast<double>(pairs) / runs;
  finding.way_m = way / runs;
  return finding;
}

}  // namespace sfw
