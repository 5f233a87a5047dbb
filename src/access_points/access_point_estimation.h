#pragma once

#include <optional>
#include <vector>

#include "structure_from_wifi/access_point_estimate.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Finds an access point from its readings.
///
/// Each position R of a grid is judged by the marginal likelihood of the mean signals of square
/// bins: power -37 +- 8 dBm at 1 m, exponent 2.1 +- .4, 0.6 +- .6 dB for each metre, as walls come
/// to on average, and +- 1.6 and 1.4 dB in the first and second harmonics of bearing. How strong
/// shadowing is and how far it reaches is chosen from 12 ways by the same likelihood. An access
/// point of unknown height is taken to hang 0.8 m above the antenna. The grid's cells are quartered
/// where the likelihood is high until they are finer than its peak. The result is mean and
/// covariance of the likelihood over all cells (doc/method/access_points.md).
///
/// @param samples   in any order
/// @param height_m  of the access point above the floor, if known
/// @return nothing if the readings do not tell: fewer than 12 bins, signals that are all alike, or
/// no better than 5 m known on some axis although there is only one place likely.
/// Deterministic; the order of samples does not matter. The search reaches 8 m beyond the path.
/// Cost is bounded: 300 bins and 5700 positions, 91 terms each, at most: 0.1 s.
std::optional<AccessPointEstimate> estimateAccessPoint(
    const std::vector<Sample>& samples, std::optional<double> height_m = std::nullopt);

/// Compares the place that an access point is said to stand at with what its readings say.
///
/// It is suspect if the estimate is farther than 1.5 m and e^6 times likelier. On simulated drives
/// (8 HouseExpo plans, 24 access points each line), share found suspect:
///
/// | noise, path       | right place | 2 m off | 3 m off | 4 m off | 5 m off |
/// |-------------------|-------------|---------|---------|---------|---------|
/// | realistic, walls  | 0           | .58     | .75     | .79     | .79     |
/// | realistic, sparse | 0           | .38     | .67     | .79     | .79     |
/// | hard, walls       | 0           | .50     | .71     | .79     | .83     |
/// | hard, sparse      | 0           | .29     | .54     | .75     | .79     |
///
/// None of 11 real ones that stand where they are said to is suspect.
///
/// @param place  [m], map frame
/// @return nothing where estimateAccessPoint returns nothing.
/// Cost as of estimateAccessPoint.
std::optional<AccessPointFit> accessPointFit(const std::vector<Sample>& samples,
                                             const Position& place,
                                             std::optional<double> height_m = std::nullopt);

}  // namespace sfw
