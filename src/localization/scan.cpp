#include "localization/scan.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace sfw {
namespace {

struct Mean {
  double value = 0.0;
  double count = 0.0;
  void add(double sample) { value += (sample - value) / ++count; }
};

template <class Iterator>
Scan scanOf(Iterator first, Iterator last) {
  Scan scan;
  scan.stamp_ns = first->stamp_ns;
  std::map<Bssid, Mean> means;
  double count = 0.0;
  for (; first != last; ++first) {
    means[first->bssid].add(first->rssi_dbm);
    scan.position += (first->antenna_in_map - scan.position) / ++count;
  }
  for (const auto& [bssid, mean] : means) {
    scan.heard.emplace_back(bssid, mean.value);
  }
  return scan;
}

/// @param is_next (first reading of a scan, reading): whether another scan starts with the reading
template <class IsNext>
std::vector<Scan> grouped(std::vector<Reading> readings, IsNext&& is_next) {
  std::stable_sort(readings.begin(), readings.end(), [](const Reading& a, const Reading& b) {
    return std::tie(a.robot, a.stamp_ns, a.bssid) < std::tie(b.robot, b.stamp_ns, b.bssid);
  });
  std::vector<Scan> scans;
  for (auto first = readings.begin(); first != readings.end();) {
    const auto last = std::find_if(first, readings.end(), [&](const Reading& reading) {
      return reading.robot != first->robot || is_next(*first, reading);
    });
    scans.push_back(scanOf(first, last));
    first = last;
  }
  return scans;
}

}  // namespace

std::vector<Scan> scansOf(std::vector<Reading> readings, std::int64_t window_ns) {
  return grouped(std::move(readings), [&](const Reading& first, const Reading& reading) {
    return reading.stamp_ns - first.stamp_ns > window_ns;
  });
}

std::vector<Scan> stretchesOf(std::vector<Reading> readings, double length_m) {
  return grouped(std::move(readings), [&](const Reading& first, const Reading& reading) {
    return (reading.antenna_in_map - first.antenna_in_map).norm() > length_m;
  });
}

Scan withoutRepeated(const Scan& scan, const Scan& before) {
  constexpr std::size_t kFewestRepeated = 5;
  constexpr double kLeastShare = 0.4;
  Scan fresh = scan;
  fresh.heard.clear();
  std::size_t common = 0;
  auto other = before.heard.begin();
  for (const auto& [bssid, rssi_dbm] : scan.heard) {
    while (other != before.heard.end() && other->first < bssid) {
      ++other;
    }
    const bool in_both = other != before.heard.end() && other->first == bssid;
    common += in_both ? 1 : 0;
    if (in_both && other->second == rssi_dbm) {
      fresh.repeated.push_back(bssid);
    } else {
      fresh.heard.emplace_back(bssid, rssi_dbm);
    }
  }
  const auto repeated = static_cast<double>(fresh.repeated.size());
  const bool repeats = fresh.repeated.size() >= kFewestRepeated &&
                       repeated >= kLeastShare * static_cast<double>(common);
  return repeats ? fresh : scan;
}

std::vector<double> wayOf(const std::vector<Scan>& scans) {
  std::vector<double> way_m(scans.size(), 0.0);
  for (std::size_t i = 1; i < scans.size(); ++i) {
    way_m[i] = way_m[i - 1] + (scans[i].position - scans[i - 1].position).norm();
  }
  return way_m;
}

}  // namespace sfw
