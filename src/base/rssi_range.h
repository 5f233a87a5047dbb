#pragma once

namespace sfw {

/// Whether a number can be the strength of a WiFi signal [dBm]. Positive ones are often percent.
inline bool isInRssiRange(double rssi_dbm) { return rssi_dbm > -120.0 && rssi_dbm <= 0.0; }

}  // namespace sfw
