#include "localization/scan_difference.h"

#include <algorithm>
#include <limits>
#include <map>

namespace sfw {

ScanDifference::ScanDifference(const std::vector<Scan>& scans) {
  constexpr std::size_t kFewestScans = 5;
  struct Radio {
    std::size_t scans = 0;
    float weakest_dbm = 0.0F;
    Eigen::Index row = 0;
  };
  std::map<Bssid, Radio> radios;
  for (const Scan& scan : scans) {
    for (const auto& [bssid, rssi_dbm] : scan.heard) {
      Radio& radio = radios[bssid];
      ++radio.scans;
      radio.weakest_dbm = std::min(radio.weakest_dbm, static_cast<float>(rssi_dbm));
    }
  }
  Eigen::Index rows = 0;
  for (auto& [bssid, radio] : radios) {
    radio.row = radio.scans < kFewestScans ? -1 : rows++;
  }
  const auto columns = static_cast<Eigen::Index>(scans.size());
  rssi_dbm_.resize(rows, columns);
  is_heard_.setConstant(rows, columns, false);
  constexpr float kSilenceDb = 2.0F;  // below the weakest signal
  for (const auto& [bssid, radio] : radios) {
    if (radio.row >= 0) {
      rssi_dbm_.row(radio.row) = radio.weakest_dbm - kSilenceDb;
    }
  }
  for (Eigen::Index i = 0; i < columns; ++i) {
    for (const auto& [bssid, rssi_dbm] : scans[static_cast<std::size_t>(i)].heard) {
      const Eigen::Index row = radios.at(bssid).row;
      if (row >= 0) {
        rssi_dbm_(row, i) = static_cast<float>(rssi_dbm);
        is_heard_(row, i) = true;
      }
    }
  }
}

double ScanDifference::between(std::size_t a, std::size_t b) const {
  constexpr Eigen::Index kFewestRadios = 3;
  const auto i = static_cast<Eigen::Index>(a);
  const auto j = static_cast<Eigen::Index>(b);
  const Eigen::Index heard = (is_heard_.col(i) || is_heard_.col(j)).count();
  if (heard == 0 || heard < std::min(kFewestRadios, rssi_dbm_.rows())) {
    return std::numeric_limits<double>::infinity();
  }
  // Where neither hears a radio, both have its value of silence, so they differ by nothing.
  return static_cast<double>((rssi_dbm_.col(i) - rssi_dbm_.col(j)).square().sum()) /
         static_cast<double>(heard);
}

double ScanDifference::usualOfNeighbours(const std::vector<Scan>& scans) const {
  constexpr double kNearWay = 5.0;  // [m], and the limits of the distance
  constexpr double kLeast = 0.5;
  constexpr double kMost = 1.5;
  constexpr std::size_t kFewestPairs = 20;
  const std::vector<double> way_m = wayOf(scans);
  std::vector<double> differences;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    for (std::size_t j = i; j-- > 0 && way_m[i] - way_m[j] < kNearWay;) {
      const double distance_m = (scans[i].position - scans[j].position).norm();
      if (distance_m > kLeast && distance_m < kMost) {
        differences.push_back(between(i, j));
      }
    }
  }
  if (differences.size() < kFewestPairs) {
    return 0.0;
  }
  const auto at = differences.begin() + static_cast<std::ptrdiff_t>(4 * differences.size() / 5);
  std::nth_element(differences.begin(), at, differences.end());
  return *at;
}

}  // namespace sfw
