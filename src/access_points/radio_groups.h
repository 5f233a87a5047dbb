#pragma once

#include <cstddef>
#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// Indices of the BSSIDs that one radio sends, ascending.
using RadioGroup = std::vector<std::size_t>;

/// Finds the BSSIDs that one radio sends (doc/method/access_points.md).
///
/// Signals of one radio are subject to the same fading. So two of its BSSIDs differ by little but
/// noise wherever both are heard at once, and are equally strong on average. Signals of two radios
/// fade independently, even on one mast. Each pair gets the log likelihood ratio of these cases.
/// Addresses that are not related need much clearer signals; related addresses prove nothing.
/// Groups are merged, the likeliest first, while the sum of the ratios of their pairs is positive.
///
/// @param table     BSSIDs with positions of the table far apart are different radios
/// @param readings  of each BSSID of the table, by stamp
/// @return groups of two or more, in the order of their first index
/// Cost: O(pairs x readings) for the BSSIDs that are heard together.
std::vector<RadioGroup> groupByRadio(const std::vector<AccessPoint>& table,
                                     const std::vector<std::vector<Reading>>& readings);

/// Whether positions of the table tell that a BSSID shares its radio with no other one. Its
/// readings do not matter to groupByRadio then.
/// @param i  its index in the table
/// O(table)
bool isAlone(std::size_t i, const std::vector<AccessPoint>& table);

/// Median difference of two BSSIDs' signals that are heard at once [dB]; 0 if there are none.
/// @param a, b  their readings by stamp
double levelDifference(const std::vector<Reading>& a, const std::vector<Reading>& b);

}  // namespace sfw
