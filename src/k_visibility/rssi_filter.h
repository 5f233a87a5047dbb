#pragma once

#include <cstddef>
#include <vector>

namespace sfw {

/// Replaces each value by the median of the `window` neighbours centred on it.
///
/// At both ends the window shrinks symmetrically, so a linear trend is kept. O(values x window).
/// @param values  in any unit
/// @param window  odd, at least 1 (1 returns the input)
std::vector<double> slidingMedian(const std::vector<double>& values, std::size_t window);

/// Smooths as slidingMedian does, with the mean.
std::vector<double> slidingMean(const std::vector<double>& values, std::size_t window);

/// Adds the loss by distance back to a signal: the result is the signal at 1 m [dBm], weakened by
/// walls alone.
///
/// @param distance_m  to the access point; less than 0.3 m counts as 0.3 m, where the far-field law
///                    ends
/// @param exponent    of the path loss: 10 exponent log10(distance) dB are added. Measured values
///                    with line of sight indoors are 0.7 to 1.7 (doc/method/k_visibility.md).
double withoutPathLoss(double rssi_dbm, double distance_m, double exponent);

}  // namespace sfw
