#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace sfw {

/// Scans that stand in texts, as an object {data: [{mac, rssi, last_seen_ms or timestamp}]}. After
/// kMostReadings readings come nulls.
/// @{

/// A scan in the output of `iw scan` or `iwlist scan`, or in one line
/// "bssid,ssid,channel,rssi,seconds,nanoseconds". A strength without dBm is left out.
/// @return null if the text is none of these
nlohmann::json scanInText(std::string_view text);

/// A scan in the keys of diagnostics, as wifiscanner publishes those of `iwlist` and `iwconfig`.
/// @param message  the values of a diagnostic_msgs/DiagnosticArray
/// @return also the header; null if no status names an access point
nlohmann::json scanInDiagnostics(const nlohmann::json& message);
/// @}

}  // namespace sfw
