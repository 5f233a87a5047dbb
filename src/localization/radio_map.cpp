#include "localization/radio_map.h"

#include <algorithm>
#include <cmath>

#include "localization/error_correlation.h"
#include "localization/map_folds.h"

namespace sfw {
namespace {

std::vector<Position> positionsOf(const std::vector<Scan>& scans) {
  std::vector<Position> positions;
  positions.reserve(scans.size());
  for (const Scan& scan : scans) {
    positions.push_back(scan.position);
  }
  return positions;
}

/// The width of the band around the mapped path where the robot may be.
PlaceLattice::Config bandOf(const std::vector<Scan>& scans, const RadioMap::Config& config) {
  constexpr double kLeastDeviationM = 0.5;
  constexpr double kMostDeviationM = 2.0;
  constexpr double kReaches = 3.0;
  PlaceLattice::Config places = config.places;
  places.deviation_m = std::clamp(distanceBetweenFolds(scans, foldsOf(scans, config.block_m)),
                                  kLeastDeviationM, kMostDeviationM);
  places.reach_m = kReaches * places.deviation_m;
  return places;
}

}  // namespace

RadioMap::RadioMap(const std::vector<Scan>& scans, const std::vector<AccessPoint>& table,
                   const Config& config)
    : config_(config),
      places_(positionsOf(scans), bandOf(scans, config)),
      motion_(motionOf(scans)),
      radios_(mappedRadios(scans, table, config.fewest_scans, config.layers.stop)) {
  const std::vector<int> folds = foldsOf(scans, config_.block_m);
  correlation_ = errorCorrelation(radios_, scans, folds, config_.layers.stop);
  temper_ = chooseTemper(places_, checkedScans(scans, folds));
  layers_.emplace(layersOf(scans, std::vector<bool>(scans.size(), true)));
}

RadioLayers RadioMap::layersOf(const std::vector<Scan>& scans,
                               const std::vector<bool>& used) const {
  std::vector<double> weights;
  for (Eigen::Index i = 0; i < correlation_.rows(); ++i) {
    weights.push_back(1.0 / static_cast<double>(correlation_.row(i).sum()));
  }
  return {places_, scans, used, radios_, weights, config_.layers};
}

std::vector<CheckedScan> RadioMap::checkedScans(const std::vector<Scan>& scans,
                                                const std::vector<int>& folds) const {
  std::vector<CheckedScan> checked;
  const std::size_t stride = scans.size() / config_.most_checked_scans + 1;
  for (const int fold : {0, 1}) {
    std::vector<bool> used;
    for (const int one : folds) {
      used.push_back(one != fold);
    }
    const RadioLayers layers = layersOf(scans, used);
    for (std::size_t i = 0; i < scans.size(); i += stride) {
      const ScanRadios radios = radiosOf(scans[i]);
      const int place = places_.nearest(scans[i].position);
      if (folds[i] == fold && place >= 0 && !radios.heard.empty()) {
        checked.push_back({layers.evidence(radios), static_cast<std::size_t>(place)});
      }
    }
  }
  return checked;
}

std::optional<std::size_t> RadioMap::numberOf(Bssid bssid) const {
  const auto found = std::lower_bound(
      radios_.begin(), radios_.end(), bssid,
      [](const MappedRadio& radio, const Bssid& wanted) { return radio.bssid < wanted; });
  if (found == radios_.end() || found->bssid != bssid) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(found - radios_.begin());
}

ScanRadios RadioMap::radiosOf(const Scan& scan) const {
  ScanRadios radios;
  for (const auto& [bssid, rssi_dbm] : scan.heard) {
    if (const auto number = numberOf(bssid)) {
      radios.heard.push_back({*number, rssi_dbm});
    }
  }
  for (const Bssid bssid : scan.repeated) {
    if (const auto number = numberOf(bssid)) {
      radios.repeated.push_back(*number);
    }
  }
  // n radios whose errors correlate by r count as n / (1 + (n - 1) r) independent ones.
  for (const HeardRadio& one : radios.heard) {
    double sum = 0.0;
    for (const HeardRadio& other : radios.heard) {
      sum += static_cast<double>(correlation_(static_cast<Eigen::Index>(one.radio),
                                              static_cast<Eigen::Index>(other.radio)));
    }
    radios.signal_weights.push_back(1.0 / sum);
  }
  return radios;
}

std::optional<std::vector<double>> RadioMap::logLikelihood(const Scan& scan) const {
  const ScanRadios radios = radiosOf(scan);
  if (radios.heard.empty()) {
    return std::nullopt;
  }
  return temper_.applied(layers_->evidence(radios));
}

}  // namespace sfw
