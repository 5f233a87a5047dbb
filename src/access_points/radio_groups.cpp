#include "access_points/radio_groups.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/median.h"
#include "radio/radio_bins.h"

namespace sfw {
namespace {

using Readings = std::vector<Reading>;

/// A radio sends its beacons one after another, and a scanner hears them within one dwell on its
/// channel.
constexpr std::int64_t kSimultaneousNs = 300'000'000;

constexpr std::size_t kFewest = 3;  // simultaneous readings: fewer tell nothing
constexpr double kSamePlaceM = 1.0;

/// Standard deviation of the difference of two given positions [m].
double deviationBetween(const AccessPoint& a, const AccessPoint& b) {
  return std::hypot(a.position_sd_m.value_or(0.0), b.position_sd_m.value_or(0.0));
}

/// Whether positions of the table tell that two BSSIDs are those of two radios.
bool areApart(const AccessPoint& a, const AccessPoint& b) {
  constexpr double kDeviations = 2.0;  // of the given positions
  return a.position_known && b.position_known &&
         (a.position - b.position).norm() > kSamePlaceM + kDeviations * deviationBetween(a, b);
}

/// Variance by fading and noise, but not by distance [dB2]. A few readings hardly change the usual
/// value.
double fadingOf(const Readings& readings) {
  constexpr double kUsualDb2 = 9.0;
  constexpr double kWeight = 2.0;  // of the usual value, as a number of differences
  std::vector<Sample> samples;
  for (const Reading& reading : readings) {
    samples.push_back({reading.antenna_in_map, reading.rssi_dbm});
  }
  const double steps = static_cast<double>(std::max<std::size_t>(samples.size(), 1) - 1);
  return (steps * readingNoise(samples) + kWeight * kUsualDb2) / (steps + kWeight);
}

/// What two BSSIDs have in common.
struct Common {
  std::size_t readings = 0;  ///< that one robot hears at once

  /// Differences of their signals [dB]. A pair of values that repeats the one before it may be
  /// cached, and counts once.
  std::vector<double> differences;
};

Common commonOf(const Readings& a, const Readings& b) {
  Common common;
  std::pair<double, double> last(1.0, 1.0);  // no signal
  std::size_t j = 0;
  for (const Reading& reading : a) {
    while (j < b.size() &&
           (b[j].robot < reading.robot ||
            (b[j].robot == reading.robot && b[j].stamp_ns < reading.stamp_ns - kSimultaneousNs))) {
      ++j;
    }
    while (j + 1 < b.size() && b[j + 1].robot == reading.robot &&
           std::abs(b[j + 1].stamp_ns - reading.stamp_ns) <=
               std::abs(b[j].stamp_ns - reading.stamp_ns)) {
      ++j;
    }
    if (j == b.size() || b[j].robot != reading.robot ||
        std::abs(b[j].stamp_ns - reading.stamp_ns) > kSimultaneousNs) {
      continue;
    }
    ++common.readings;
    const std::pair<double, double> now(reading.rssi_dbm, b[j].rssi_dbm);
    if (now != last) {
      common.differences.push_back(now.first - now.second);
      last = now;
    }
  }
  return common;
}

/// Log density of a normal distribution, up to a constant.
double logNormal(double away, double deviation) {
  return -0.5 * (away / deviation) * (away / deviation) - std::log(deviation);
}

/// The same for a difference of two signals, of which a few are outliers, so that none of them
/// decides alone.
double logDifference(double away, double deviation) {
  constexpr double kOutliers = 0.05;   // share
  constexpr double kOutlierDb = 10.0;  // their deviation
  return std::log(std::exp(logNormal(away, deviation)) +
                  kOutliers * std::exp(logNormal(away, kOutlierDb)));
}

/// Log likelihood of differences about their median, for the likeliest of some deviations [dB].
template <std::size_t kCount>
double logLikelihoodOf(const std::vector<double>& differences, double middle,
                       const std::array<double, kCount>& deviations_db) {
  double best = -std::numeric_limits<double>::infinity();
  for (const double deviation : deviations_db) {
    double sum = 0.0;
    for (const double difference : differences) {
      sum += logDifference(difference - middle, deviation);
    }
    best = std::max(best, sum);
  }
  return best;
}

/// Log likelihood ratio of one radio to two, given the differences of their signals.
/// @param fading_db2  of both signals together
double logRatioOf(const std::vector<double>& differences, double fading_db2) {
  // Beacons of one radio that a robot heard within one second differed by 1.45 dB (recording of
  // github.com/RMiyagusuku/ros-wifi-localization).
  constexpr std::array<double, 3> kOneRadioDb = {1.0, 1.5, 2.2};
  constexpr double kLeastFadingDb = 2.0;
  constexpr double kIndependent = 0.5;    // share of the differences, since fading is correlated
  constexpr double kOneLevelDb = 1.0;     // of the mean difference of one radio
  constexpr double kOtherLevelDb = 12.0;  // of two
  const double middle = median(differences);
  // Signals of two radios differ by their fading at least, and by their distances if they stand at
  // two places.
  const double fading = std::max(kLeastFadingDb, std::sqrt(fading_db2));
  const std::array<double, 4> two_radios_db = {fading, std::max(fading, 4.0), std::max(fading, 7.0),
                                               std::max(fading, 12.0)};
  const double ratio = logLikelihoodOf(differences, middle, kOneRadioDb) -
                       logLikelihoodOf(differences, middle, two_radios_db);
  const double level =
      std::sqrt(kOneLevelDb * kOneLevelDb + 2.0 / static_cast<double>(differences.size()));
  return kIndependent * ratio + logNormal(middle, level) - logNormal(middle, kOtherLevelDb);
}

/// Rates pairs of BSSIDs.
class Pairs {
 public:
  Pairs(const std::vector<AccessPoint>& table, const std::vector<Readings>& readings)
      : table_(table), readings_(readings) {
    for (const Readings& radio : readings) {
      fading_db2_.push_back(fadingOf(radio));
    }
  }

  /// Log odds that two BSSIDs are one radio; 0 if nothing tells.
  double operator()(std::size_t i, std::size_t j) const {
    // Few pairs of a building are one radio, if their addresses do not tell, or if one of them is
    // often heard without the other. One radio sends both equally far.
    constexpr double kUnlikely = -6.0;
    constexpr double kLeastCommon = 0.25;  // of the readings of the one that is heard more
    constexpr double kNever = -1e6;        // no signal outweighs this
    if (readings_[i].size() < kFewest || readings_[j].size() < kFewest) {
      return 0.0;
    }
    const AccessPoint& a = table_[i];
    const AccessPoint& b = table_[j];
    if (areApart(a, b)) {
      return kNever;
    }
    const Common common = commonOf(readings_[i], readings_[j]);
    if (common.differences.size() < kFewest) {
      return 0.0;
    }
    const std::size_t most = std::max(readings_[i].size(), readings_[j].size());
    const bool is_seldom_common =
        static_cast<double>(common.readings) < kLeastCommon * static_cast<double>(most);
    return logRatioOf(common.differences, fading_db2_[i] + fading_db2_[j]) +
           (a.bssid.isRelatedTo(b.bssid) ? 0.0 : kUnlikely) + (is_seldom_common ? kUnlikely : 0.0);
  }

 private:
  const std::vector<AccessPoint>& table_;
  const std::vector<Readings>& readings_;
  std::vector<double> fading_db2_;
};

/// The sets that pairs of positive odds connect. Groups never reach beyond them.
std::vector<RadioGroup> connectedSets(const Pairs& pairs, std::size_t count) {
  std::vector<std::size_t> set_of(count);
  std::iota(set_of.begin(), set_of.end(), std::size_t{0});
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      if (set_of[i] != set_of[j] && pairs(i, j) > 0.0) {
        std::replace(set_of.begin(), set_of.end(), std::size_t{set_of[j]}, std::size_t{set_of[i]});
      }
    }
  }
  std::vector<RadioGroup> sets(count);
  for (std::size_t i = 0; i < count; ++i) {
    sets[set_of[i]].push_back(i);
  }
  return sets;
}

/// Merges the members of a set, the likeliest first, while that is likelier than not.
std::vector<RadioGroup> merged(const Pairs& pairs, const RadioGroup& set) {
  const auto size = static_cast<Eigen::Index>(set.size());
  Eigen::MatrixXd odds = Eigen::MatrixXd::Zero(size, size);
  std::vector<RadioGroup> groups;
  for (std::size_t i = 0; i < set.size(); ++i) {
    groups.push_back({set[i]});
    for (std::size_t j = 0; j < i; ++j) {
      odds(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = pairs(set[j], set[i]);
    }
  }
  odds += odds.transpose().eval();
  Eigen::Index into = 0;
  Eigen::Index from = 0;
  while (odds.maxCoeff(&from, &into) > 0.0) {
    odds.col(into) += odds.col(from);
    odds.row(into) += odds.row(from);
    odds.col(from).setZero();
    odds.row(from).setZero();
    odds(into, into) = 0.0;
    RadioGroup& source = groups[static_cast<std::size_t>(from)];
    RadioGroup& target = groups[static_cast<std::size_t>(into)];
    target.insert(target.end(), source.begin(), source.end());
    source.clear();
  }
  return groups;
}

}  // namespace

bool isAlone(std::size_t i, const std::vector<AccessPoint>& table) {
  for (std::size_t j = 0; j < table.size(); ++j) {
    if (j != i && !areApart(table[i], table[j])) {
      return false;
    }
  }
  return true;
}

double levelDifference(const Readings& a, const Readings& b) {
  const std::vector<double> differences = commonOf(a, b).differences;
  return differences.empty() ? 0.0 : median(differences);
}

std::vector<RadioGroup> groupByRadio(const std::vector<AccessPoint>& table,
                                     const std::vector<Readings>& readings) {
  const Pairs pairs(table, readings);
  std::vector<RadioGroup> groups;
  for (const RadioGroup& set : connectedSets(pairs, table.size())) {
    for (RadioGroup& group : set.size() > 1 ? merged(pairs, set) : std::vector<RadioGroup>()) {
      if (group.size() > 1) {
        std::sort(group.begin(), group.end());
        groups.push_back(std::move(group));
      }
    }
  }
  std::sort(groups.begin(), groups.end());
  return groups;
}

}  // namespace sfw
