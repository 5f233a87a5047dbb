#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "evaluation/nearest_fingerprints.h"
#include "localization/particle_filter.h"
#include "localization/place_estimate.h"
#include "localization/radio_map.h"
#include "localization/scan.h"

namespace sfw {

/// A scan with the places that each method gives it.
struct LocalizedScan {
  std::optional<PlaceEstimate> filtered;  ///< by the particle filter, from all scans so far
  std::optional<PlaceEstimate> alone;     ///< by this scan alone
};

/// Localises scans one after the other.
/// @param scans  by time
/// @param steps  of the odometry, as of odometrySteps
std::vector<LocalizedScan> localizeScans(const RadioMap& map, const std::vector<Scan>& scans,
                                         const std::vector<std::optional<Position>>& steps,
                                         const ParticleFilter::Config& config);

/// Distances from the true positions [m].
struct LocalizationErrors {
  std::size_t scans = 0;
  double mean_m = 0.0;
  double median_m = 0.0;
  double largest_of_90_percent_m = 0.0;
  /// Share of true positions in the ellipse that should hold 90 % of them; none for a method that
  /// gives no ellipse.
  std::optional<double> in_ellipse;
};

/// The errors of each method. Scans that the map cannot localise are left out of all.
struct LocalizationEvaluation {
  LocalizationErrors filtered;
  LocalizationErrors alone;
  LocalizationErrors nearest;  ///< of NearestFingerprints
};

/// @param scans  with their true positions
LocalizationEvaluation evaluateLocalization(const std::vector<Scan>& scans,
                                            const std::vector<LocalizedScan>& localized,
                                            const NearestFingerprints& fingerprints);

}  // namespace sfw
