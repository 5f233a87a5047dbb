#pragma once

#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// Predicts the signals of one access point by ordinary kriging: a constant mean and exponential
/// shadowing with a nugget, all fitted to the samples. It knows of no access point.
/// @param known  samples, not empty
/// @return predicted signals [dBm], one for each position
std::vector<double> predictByKriging(const std::vector<Sample>& known,
                                     const std::vector<Position>& positions);

/// The same by MRPT's CWirelessPowerGridMap2D, with the kernel method DM+V (Lilienthal et al.
/// 2009). Its Markov random field takes seconds for each access point.
/// @param sigma_m  of the kernel
std::vector<double> predictByMrpt(const std::vector<Sample>& known,
                                  const std::vector<Position>& positions, double sigma_m);

}  // namespace sfw
