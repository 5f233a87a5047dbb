#include "checks/sentinel_checks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <unordered_map>

#include "base/erase_if.h"
#include "checks/quantile.h"

namespace sfw {
namespace {

constexpr std::size_t kFewestReadings = 20;  // of an access point
constexpr std::size_t kFewest = 5;           // of a value
constexpr double kIsolated = 6.0;            // [dB]
constexpr std::size_t kMostValues = 4;       // of one access point

using Counts = std::map<double, std::size_t>;  // readings of each value

Counts countsOf(const ReadingRefs& readings) {
  std::unordered_map<double, std::size_t> unordered;  // readings are many, and values few
  for (const Reading& reading : readings) {
    ++unordered[reading.rssi_dbm];
  }
  return {unordered.begin(), unordered.end()};
}

/// Readings of other values within a distance.
std::size_t othersWithin(double distance_db, const Counts& counts, double value) {
  std::size_t others = 0;
  const auto end = counts.upper_bound(value + distance_db);
  for (auto one = counts.lower_bound(value - distance_db); one != end; ++one) {
    others += one->first == value ? 0 : one->second;
  }
  return others;
}

std::size_t mostWithin(double distance_db, const Counts& counts, double value) {
  std::size_t most = 0;
  const auto end = counts.upper_bound(value + distance_db);
  for (auto one = counts.lower_bound(value - distance_db); one != end; ++one) {
    most = std::max(most, one->first == value ? std::size_t{0} : one->second);
  }
  return most;
}

/// Where and when an access point has a value.
struct Occurrence {
  std::size_t runs = 0;        // of readings of that value in sequence
  double extent_m = 0.0;       // diagonal of their places
  std::size_t compared = 0;    // with signals of the same place
  double usual_jump_db = 0.0;  // median distance to these
};

Occurrence occurrenceOf(double value, const ReadingRefs& readings) {
  constexpr double kSamePlace = 1.0;  // [m]
  Occurrence occurrence;
  Box places;
  std::vector<double> jumps;
  const Reading* before = nullptr;  // the last one of another value
  std::vector<const Reading*> waiting;
  const auto jump = [&](const Reading& one, const Reading& other) {
    if ((one.antenna_in_map - other.antenna_in_map).norm() < kSamePlace) {
      jumps.push_back(std::abs(value - other.rssi_dbm));
    }
  };
  for (const Reading& reading : readings) {
    if (reading.rssi_dbm != value) {
      for (const Reading* one : waiting) {
        jump(*one, reading);
      }
      waiting.clear();
      before = &reading;
      continue;
    }
    occurrence.runs += waiting.empty() ? 1 : 0;
    places.extend(reading.antenna_in_map);
    if (before != nullptr) {
      jump(reading, *before);
    }
    waiting.push_back(&reading);
  }
  occurrence.extent_m = places.isEmpty() ? 0.0 : places.diagonal().norm();
  occurrence.compared = jumps.size();
  occurrence.usual_jump_db = quantile(jumps, 0.5);
  return occurrence;
}

/// The values that programs write where they hear nothing.
bool isWellKnown(double value) {
  constexpr double kKnown[] = {0.0, -1.0, -99.0, -100.0, -105.0, -110.0, -115.0, -119.0};
  return std::find(std::begin(kKnown), std::end(kKnown), value) != std::end(kKnown);
}

/// Whether all signals but those of the value are far from it.
bool isFarFromTheRest(double value, std::size_t count, const Counts& counts,
                      const ReadingRefs& readings) {
  constexpr double kFewInBetween = 0.1;  // of the count
  constexpr std::size_t kFewestRuns = 3;
  constexpr std::size_t kFewestOthers = 20;
  constexpr std::size_t kFewestValues = 6;
  constexpr std::size_t kManyAlike = 20;
  constexpr double kEverywhere = 3.0;  // [m]
  if (static_cast<double>(othersWithin(kIsolated, counts, value)) >
      kFewInBetween * static_cast<double>(count)) {
    return false;
  }
  const Occurrence found = occurrenceOf(value, readings);
  if (isWellKnown(value)) {
    return found.runs >= kFewestRuns || (count >= kManyAlike && found.extent_m >= kEverywhere);
  }
  const bool is_extreme = value == counts.begin()->first || value == counts.rbegin()->first;
  return is_extreme && found.runs >= kFewestRuns && counts.size() >= kFewestValues &&
         readings.size() - count >= kFewestOthers;
}

/// Whether the value interrupts signals of another strength again and again.
bool isOutOfPlace(double value, std::size_t count, const Counts& counts,
                  const ReadingRefs& readings) {
  constexpr double kManyOfAll = 0.02;
  constexpr std::size_t kTimesMore = 3;  // than of any value nearby
  constexpr double kNearby = 5.0;        // [dB]
  constexpr std::size_t kFewestRuns = 5;
  constexpr double kJump = 12.0;  // [dB]
  if (static_cast<double>(count) < kManyOfAll * static_cast<double>(readings.size()) ||
      count < kTimesMore * mostWithin(kNearby, counts, value)) {
    return false;
  }
  const Occurrence found = occurrenceOf(value, readings);
  return found.runs >= kFewestRuns && 2 * found.compared >= count && found.usual_jump_db >= kJump;
}

/// The most frequent value that stands for "not heard".
std::optional<double> sentinelOf(const ReadingRefs& readings) {
  constexpr double kLeastShare = 0.005;
  if (readings.size() < kFewestReadings) {
    return std::nullopt;
  }
  const Counts counts = countsOf(readings);
  std::optional<double> found;
  std::size_t most = std::max(
      kFewest - 1, static_cast<std::size_t>(kLeastShare * static_cast<double>(readings.size())));
  for (const auto& [value, count] : counts) {
    if (count > most && (isFarFromTheRest(value, count, counts, readings) ||
                         isOutOfPlace(value, count, counts, readings))) {
      found = value;
      most = count;
    }
  }
  return found;
}

/// The value of nearly all signals that the mapper refused.
std::optional<double> refusedSentinelOf(const ReadingRefs& refused, std::size_t accepted) {
  constexpr double kNearlyAll = 0.8;
  constexpr double kPercent = 100.0;
  if (refused.size() < kFewest) {
    return std::nullopt;
  }
  const Counts counts = countsOf(refused);
  const auto most =
      std::max_element(counts.begin(), counts.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  const bool may_be_percent =
      most->first > 1.0 && most->first < kPercent && accepted < most->second;
  return !may_be_percent && static_cast<double>(most->second) >=
                                kNearlyAll * static_cast<double>(refused.size())
             ? std::optional(most->first)
             : std::nullopt;
}

using Findings = std::map<double, SentinelFinding>;

void add(double value, const Bssid& bssid, std::size_t count, Findings& findings) {
  SentinelFinding& finding = findings[value];
  finding.value_dbm = value;
  finding.readings += count;
  finding.radios.push_back(bssid);
}

std::size_t countOf(double value, const ReadingRefs& readings) {
  return static_cast<std::size_t>(
      std::count_if(readings.begin(), readings.end(),
                    [&](const Reading& reading) { return reading.rssi_dbm == value; }));
}

void removeValue(double value, ReadingRefs& readings) {
  eraseIf(readings, [&](const Reading& reading) { return reading.rssi_dbm == value; });
}

/// The access points with too few readings of a value to show by themselves what it stands for.
void addOthers(const std::vector<AccessPoint>& table, const std::vector<ReadingRefs>& readings,
               Findings& findings) {
  for (auto& [value, finding] : findings) {
    const std::vector<Bssid> known = finding.radios;
    for (std::size_t i = 0; i < table.size(); ++i) {
      const std::size_t count = countOf(value, readings[i]);
      if (count > 0 && std::find(known.begin(), known.end(), table[i].bssid) == known.end() &&
          othersWithin(kIsolated, countsOf(readings[i]), value) == 0) {
        add(value, table[i].bssid, count, findings);
      }
    }
  }
}

}  // namespace

std::vector<SentinelFinding> findSentinels(const std::vector<AccessPoint>& table,
                                           const std::vector<ReadingRefs>& readings,
                                           const std::vector<ReadingRefs>& refused) {
  Findings findings;
  for (std::size_t i = 0; i < table.size(); ++i) {
    std::optional<double> value = sentinelOf(readings[i]);
    ReadingRefs rest;  // the others
    if (value) {
      rest = readings[i];
    }
    for (std::size_t values = 0; value && values < kMostValues; ++values) {
      add(*value, table[i].bssid, countOf(*value, rest), findings);
      removeValue(*value, rest);
      value = sentinelOf(rest);
    }
  }
  addOthers(table, readings, findings);
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (const std::optional<double> value = refusedSentinelOf(refused[i], readings[i].size())) {
      add(*value, table[i].bssid, countOf(*value, refused[i]), findings);
    }
  }
  std::vector<SentinelFinding> all;
  for (const auto& [value, finding] : findings) {
    all.push_back(finding);
  }
  return all;
}

bool isSentinel(const std::vector<SentinelFinding>& sentinels, const Bssid& bssid,
                double rssi_dbm) {
  return std::any_of(sentinels.begin(), sentinels.end(), [&](const SentinelFinding& sentinel) {
    return sentinel.value_dbm == rssi_dbm &&
           std::find(sentinel.radios.begin(), sentinel.radios.end(), bssid) !=
               sentinel.radios.end();
  });
}

}  // namespace sfw
