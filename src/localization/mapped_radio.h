#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

#include "localization/scan.h"
#include "localization/signal_field.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// One BSSID of the radio map with the scans in which it was heard.
struct MappedRadio {
  Bssid bssid;
  std::vector<std::size_t> scans;  ///< numbers of the scans, ascending
  std::vector<double> rssi_dbm;    ///< in each of them
  SignalLaw law;
};

/// A reading by the number of its radio in the map.
struct HeardRadio {
  std::size_t radio = 0;
  double rssi_dbm = 0.0;
};

/// The radios heard in at least `fewest_scans` scans, by BSSID, with their laws.
/// @param table access points; a known position is the source of the law
/// @param stop  once it is true, the other radios are left out; may be nullptr
std::vector<MappedRadio> mappedRadios(const std::vector<Scan>& scans,
                                      const std::vector<AccessPoint>& table,
                                      std::size_t fewest_scans, const std::atomic<bool>* stop);

/// Whether work is to end early. The flag may be nullptr.
inline bool isStopped(const std::atomic<bool>* stop) { return stop != nullptr && *stop; }

/// The readings of some scans: those for which `used` is true.
std::vector<Sample> samplesOf(const MappedRadio& radio, const std::vector<Scan>& scans,
                              const std::vector<bool>& used);

}  // namespace sfw
