#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "radio/radio_bins.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Prior means of the log-distance law; the priors around them are wide.
constexpr double kPriorPowerDbm = -37.0;  ///< received power at 1 m
constexpr double kPriorExponent = 2.1;    ///< of the path loss

/// The height of an access point above the antenna [m]. If it is known above the floor, the antenna
/// is assumed to be 0.6 m above the floor. Otherwise both are assumed to be at one height.
double antennaToAccessPoint(std::optional<double> height_m);

/// A distance in space [m] from its square on the floor [m2], which counts as at least that of
/// kNearFieldM.
/// @param rise_m  as of antennaToAccessPoint
inline double spaceDistance(double square_m2, double rise_m) {
  return std::sqrt(std::max(square_m2, kNearFieldM * kNearFieldM) + rise_m * rise_m);
}

/// 10 log10 of the distance in space in metres, as of spaceDistance: the factor of the exponent in
/// the log-distance law.
double logDistance(const AccessPointBins& access_point, const Position& antenna);

/// Share of the variance left by the log-distance law that the walls' losses explain (R squared,
/// 0 to 1). The rest is noise, furniture, or a wrong position of an access point.
/// @param ray_loss_db  of each bin of each access point
/// Access points with fewer than ten bins are skipped.
double explainedVariance(const std::vector<AccessPointBins>& access_points,
                         const std::vector<std::vector<double>>& ray_loss_db);

}  // namespace sfw
