#include "evaluation/nearest_fingerprints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/median.h"
#include "localization/map_folds.h"

namespace sfw {
namespace {

using Near = std::vector<std::pair<double, std::size_t>>;  // distance [dB] and number of a scan

double distanceBetween(const Scan& a, const Scan& b, double missing_dbm) {
  double squares = 0.0;
  const auto add = [&](double one, double other) { squares += (one - other) * (one - other); };
  auto i = a.heard.begin();
  auto j = b.heard.begin();
  while (i != a.heard.end() || j != b.heard.end()) {
    if (j == b.heard.end() || (i != a.heard.end() && i->first < j->first)) {
      add(i++->second, missing_dbm);
    } else if (i == a.heard.end() || j->first < i->first) {
      add(missing_dbm, j++->second);
    } else {
      add(i++->second, j++->second);
    }
  }
  return std::sqrt(squares);
}

template <class Use>
Near nearestTo(const Scan& scan, const std::vector<Scan>& mapped, double missing_dbm,
               const Use& use) {
  constexpr std::size_t kMost = 15;
  Near near;
  for (std::size_t i = 0; i < mapped.size(); ++i) {
    if (use(i)) {
      near.emplace_back(distanceBetween(scan, mapped[i], missing_dbm), i);
    }
  }
  const std::size_t kept = std::min(near.size(), kMost);
  std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(kept), near.end());
  near.resize(kept);
  return near;
}

Position meanOf(const Near& near, const std::vector<Scan>& mapped, std::size_t neighbours,
                bool weighted) {
  constexpr double kLeastDistanceDb = 1e-3;
  Position sum = Position::Zero();
  double weights = 0.0;
  for (std::size_t i = 0; i < std::min(neighbours, near.size()); ++i) {
    const double weight = weighted ? 1.0 / std::max(near[i].first, kLeastDistanceDb) : 1.0;
    sum += weight * mapped[near[i].second].position;
    weights += weight;
  }
  return sum / weights;
}

}  // namespace

NearestFingerprints::NearestFingerprints(const std::vector<Scan>& mapped, double block_m)
    : mapped_(mapped) {
  constexpr std::size_t kChoices[] = {1, 2, 3, 4, 5, 7, 10, 15};
  constexpr std::size_t kMostChecked = 400;
  double weakest_dbm = 0.0;
  for (const Scan& scan : mapped) {
    for (const auto& [bssid, rssi_dbm] : scan.heard) {
      weakest_dbm = std::min(weakest_dbm, rssi_dbm);
    }
  }
  missing_dbm_ = weakest_dbm - 1.0;
  const std::vector<int> folds = foldsOf(mapped, block_m);
  std::vector<std::pair<std::size_t, Near>> checked;
  for (std::size_t i = 0; i < mapped.size(); i += mapped.size() / kMostChecked + 1) {
    Near near = nearestTo(mapped[i], mapped, missing_dbm_,
                          [&](std::size_t other) { return folds[other] != folds[i]; });
    if (!near.empty()) {
      checked.emplace_back(i, std::move(near));
    }
  }
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t neighbours : kChoices) {
    for (const bool weighted : {false, true}) {
      std::vector<double> errors_m;
      for (const auto& [scan, near] : checked) {
        errors_m.push_back(
            (meanOf(near, mapped, neighbours, weighted) - mapped[scan].position).norm());
      }
      if (errors_m.empty()) {
        continue;
      }
      const double middle_m = median(std::move(errors_m));
      if (middle_m < least) {
        least = middle_m;
        neighbours_ = neighbours;
        weighted_ = weighted;
      }
    }
  }
}

Position NearestFingerprints::locate(const Scan& scan) const {
  const Near near = nearestTo(scan, mapped_, missing_dbm_, [](std::size_t) { return true; });
  return meanOf(near, mapped_, neighbours_, weighted_);
}

}  // namespace sfw
