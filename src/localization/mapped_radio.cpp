#include "localization/mapped_radio.h"

#include <map>
#include <optional>
#include <utility>

namespace sfw {

std::vector<MappedRadio> mappedRadios(const std::vector<Scan>& scans,
                                      const std::vector<AccessPoint>& table,
                                      std::size_t fewest_scans, const std::atomic<bool>* stop) {
  std::map<Bssid, MappedRadio> heard;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    for (const auto& [bssid, rssi_dbm] : scans[i].heard) {
      MappedRadio& radio = heard[bssid];
      radio.bssid = bssid;
      radio.scans.push_back(i);
      radio.rssi_dbm.push_back(rssi_dbm);
    }
  }
  std::map<Bssid, Position> places;
  for (const AccessPoint& access_point : table) {
    if (access_point.position_known) {
      places.emplace(access_point.bssid, access_point.position);
    }
  }
  std::vector<MappedRadio> radios;
  const std::vector<bool> all(scans.size(), true);
  for (auto& [bssid, radio] : heard) {
    if (radio.scans.size() < fewest_scans || isStopped(stop)) {
      continue;
    }
    const auto place = places.find(bssid);
    radio.law = learnSignalLaw(
        samplesOf(radio, scans, all),
        place == places.end() ? std::nullopt : std::optional<Position>(place->second));
    radios.push_back(std::move(radio));
  }
  return radios;
}

std::vector<Sample> samplesOf(const MappedRadio& radio, const std::vector<Scan>& scans,
                              const std::vector<bool>& used) {
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < radio.scans.size(); ++i) {
    if (used[radio.scans[i]]) {
      samples.push_back({scans[radio.scans[i]].position, radio.rssi_dbm[i]});
    }
  }
  return samples;
}

}  // namespace sfw
