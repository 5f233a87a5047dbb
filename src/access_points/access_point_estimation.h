#pragma once

#include <optional>
#include <vector>

#include "structure_from_wifi/access_point_estimate.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Estimates the position of an access point from its readings (doc/method/access_points.md).
///
/// The readings are averaged in square bins. Each position of a grid gets the marginal likelihood
/// of the bins' means. The priors are: power -37 +- 8 dBm at 1 m, exponent 2.1 +- 0.4, walls 0.6 +-
/// 0.6 dB/m, and first and second harmonics of the bearing +- 1.6 and 1.4 dB. The same likelihood
/// chooses the strength and reach of shadow fading from 12 pairs. An access point of unknown height
/// is assumed to be 0.8 m above the antenna. Grid cells of high likelihood are quartered twice. The
/// result is the mean and covariance of the likelihood over all cells.
///
/// @param samples   in any order; map frame
/// @param height_m  of the access point above the floor, if known
/// @return nothing if the readings do not determine a position: fewer than 12 bins, signals that
/// vary by less than 1 dB, or a standard deviation above 5 m on an axis although only one position
/// is likely.
/// Deterministic; the order of samples does not matter. The search reaches 8 m beyond the path.
/// Cost is bounded by 300 bins and 3900 positions, 91 terms each: 0.03 s. Usually it is 0.02 s.
std::optional<AccessPointEstimate> estimateAccessPoint(
    const std::vector<Sample>& samples, std::optional<double> height_m = std::nullopt);

/// A given position that may be wrong: a Gaussian, alike on both axes.
struct PositionPrior {
  Position mean = Position::Zero();  ///< [m], map frame
  double deviation_m = 1.0;          ///< standard deviation on each axis, above 0
};

/// Estimates the position of an access point from its readings and a prior: the mean and covariance
/// of the likelihood of estimateAccessPoint times the prior.
///
/// The search covers four standard deviations of the prior, but not more than 8 m beyond the path
/// and the prior's mean. Readings that determine no position leave the prior as it is, with `bins`
/// and `readings` 0.
/// Deterministic; the order of samples does not matter. The cost is that of estimateAccessPoint.
AccessPointEstimate estimateAccessPoint(const std::vector<Sample>& samples,
                                        const PositionPrior& prior,
                                        std::optional<double> height_m = std::nullopt);

/// Compares the configured position of an access point with its readings.
///
/// The access point is suspect if the estimate is more than 1.5 m away and e^6 times more likely.
/// Share of access points found suspect on simulated drives (8 HouseExpo plans, 24 access points in
/// each line), by the error of the configured position:
///
/// | noise, path       | 0 m | 2 m | 3 m | 4 m | 5 m |
/// |-------------------|-----|-----|-----|-----|-----|
/// | realistic, walls  | 0   | .58 | .75 | .79 | .79 |
/// | realistic, sparse | 0   | .38 | .67 | .79 | .79 |
/// | hard, walls       | 0   | .50 | .71 | .79 | .83 |
/// | hard, sparse      | 0   | .29 | .54 | .75 | .79 |
///
/// None of 11 real access points with correct positions is suspect.
///
/// A position with a standard deviation is a prior. The log ratio then compares the largest
/// likelihood with the largest product of likelihood and prior, over all positions. So it is
/// suspect only if its own uncertainty does not explain the signals.
///
/// @param configured   position in the table of access points [m], map frame
/// @param deviation_m  its standard deviation on each axis, above 0; empty: it is exact
/// @return nothing where estimateAccessPoint returns nothing.
/// The cost is that of estimateAccessPoint.
std::optional<AccessPointFit> accessPointFit(const std::vector<Sample>& samples,
                                             const Position& configured,
                                             std::optional<double> height_m = std::nullopt,
                                             std::optional<double> deviation_m = std::nullopt);

}  // namespace sfw
