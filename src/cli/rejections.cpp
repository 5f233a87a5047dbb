#include "cli/rejections.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <utility>
#include <vector>

#include "base/rssi_range.h"
#include "cli/warnings.h"

namespace sfw {
namespace {

/// Names the BSSIDs with the most readings; report.json has all of them.
std::string mostHeard(const std::map<Bssid, std::size_t>& readings) {
  constexpr std::size_t kMostNamed = 3;
  std::vector<std::pair<Bssid, std::size_t>> by_count(readings.begin(), readings.end());
  std::stable_sort(by_count.begin(), by_count.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text =
      std::to_string(readings.size()) + (readings.size() == 1 ? " BSSID" : " BSSIDs");
  for (std::size_t i = 0; i < std::min(kMostNamed, by_count.size()); ++i) {
    text += (i == 0 ? ": " : ", ") + by_count[i].first.str() + " " +
            std::to_string(by_count[i].second) + " times";
  }
  return text + (by_count.size() > kMostNamed ? ", ..." : "");
}

/// The refused readings that the notes on findings tell of.
std::size_t toldByNotes(InsertResult reason, std::size_t refused,
                        const RecordingFindings& findings) {
  if (reason == InsertResult::kPositionTooFar) {
    const bool has_note = findings.units && findings.units->length != LengthUnit::kMetres;
    return has_note ? refused : 0;
  }
  if (reason != InsertResult::kRssiOutOfRange) {
    return 0;
  }
  std::size_t told = findings.signal_unit ? findings.signal_unit->readings : 0;
  for (const SentinelFinding& sentinel : findings.sentinels) {
    told += isInRssiRange(sentinel.value_dbm) ? 0 : sentinel.readings;
  }
  return told;
}

}  // namespace

void reportRejections(const std::string& source, const Rejections& rejections,
                      const RecordingFindings& findings, bool any_used) {
  for (const auto& [reason, refused] : rejections.count) {
    const std::size_t told = toldByNotes(reason, refused, findings);
    if (told >= refused) {
      continue;
    }
    const std::size_t count = refused - told;
    const bool is_unknown = reason == InsertResult::kUnknownAccessPoint;
    const std::string text =
        source + ": " + std::to_string(count) + (count == 1 ? " reading" : " readings") +
        " left out: " + toString(reason) +
        (is_unknown ? " (" + mostHeard(rejections.unknown_access_points) + ")" : "");
    if (is_unknown && any_used) {
      std::cerr << "sfw: " << text << '\n';
    } else {
      warn(text);
    }
  }
}

}  // namespace sfw
