#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace sfw {

/// The readings of a message that are taken, at most: more than any radio hears, and more than a
/// program collects between two messages.
inline constexpr std::size_t kMostReadings = 10000;

/// What the numbers of a signal strength mean.
enum class SignalUnit {
  kDbm,          ///< dBm
  kNegative,     ///< dBm without its sign
  kQuality,      ///< twice the dBm above -100, as NetworkManager has it
  kHundredthDbm  ///< 100 a dBm (mBm), as the kernel has it
};

/// Where the readings of a message of some type are.
///
/// A path names fields from a reading inwards, joined by dots; a path that a reading lacks starts
/// at the message. `macs[]` in a path is an element of the list `macs`: the first reading has the
/// first element of each such list, and so on.
struct ScanFormat {
  std::string_view type = {};      ///< package/Name; "*/Name" for any package; empty: no format
  std::string_view readings = {};  ///< lists of readings; empty: the message is one, or has lists[]
  std::string_view bssid = {};     ///< path of the address, text or six bytes; or an address
  std::string_view rssi = {};      ///< path of the strength; the mean counts if it is a list
  SignalUnit unit = SignalUnit::kDbm;
  std::string_view stamp = "header.stamp";  ///< path of the time; without it that of receipt counts
  double stamp_unit_s = 1.0;                ///< of a stamp that is a number [s]
  std::string_view age = {};                ///< path of the time between reading and stamp
  double age_unit_s = 1.0;                  ///< [s]
  std::string_view span_ms = {};  ///< path of the duration [ms] of a mean, from the stamp on
  std::string_view fresh = {};    ///< path of a flag; a reading where it is false is left out
  std::string_view kind = {};     ///< path of a text; a reading where it is not `WiFi` is left out
  bool is_link = false;           ///< without an address or a strength, the radio is not associated
  bool has_zero_dbm = false;      ///< 0 dBm is a strength, not a missing one

  // For the table of known formats.
  constexpr ScanFormat in(SignalUnit of_rssi) const {
    ScanFormat format = *this;
    format.unit = of_rssi;
    return format;
  }
  constexpr ScanFormat stampedBy(std::string_view path, double unit_s = 1.0) const {
    ScanFormat format = *this;
    format.stamp = path;
    format.stamp_unit_s = unit_s;
    return format;
  }
  constexpr ScanFormat agedBy(std::string_view path, double unit_s) const {
    ScanFormat format = *this;
    format.age = path;
    format.age_unit_s = unit_s;
    return format;
  }
  constexpr ScanFormat spanning(std::string_view path) const {
    ScanFormat format = *this;
    format.span_ms = path;
    return format;
  }
  constexpr ScanFormat freshBy(std::string_view path) const {
    ScanFormat format = *this;
    format.fresh = path;
    return format;
  }
  constexpr ScanFormat ofKind(std::string_view path) const {
    ScanFormat format = *this;
    format.kind = path;
    return format;
  }
  constexpr ScanFormat asLink() const {
    ScanFormat format = *this;
    format.is_link = true;
    return format;
  }
  constexpr ScanFormat withZeroDbm() const {
    ScanFormat format = *this;
    format.has_zero_dbm = true;
    return format;
  }
};

/// The known formats. A message has the first one of its type whose fields it has: several packages
/// use one name for different messages.
inline constexpr ScanFormat kScanFormats[] = {
    ScanFormat{"structure_from_wifi/WifiScan", "readings", "bssid", "rssi_dbm"}
        .agedBy("age_s", 1.0)
        .withZeroDbm(),
    ScanFormat{"wireless_msgs/Connection", "", "bssid", "signal_level"}.asLink(),
    ScanFormat{"*/WifiStatus", "", "access_point", "signal_level"}.asLink(),  // jsk_network_tools
    ScanFormat{"*/WifiStatus", "devices[].stations", "bssid", "signal"},      // smd_wifi_monitor
    ScanFormat{"*/WifiStatus", "devices", "station.bssid", "station.signal"},
    ScanFormat{"*/AccessPoint", "", "macaddr", "signal"}.asLink(),  // pr2_msgs, wifi_ddwrt
    // wifi_ddwrt, access_point_control, cob_msgs
    ScanFormat{"*/SiteSurvey", "networks", "macattr", "rssi"},
    // rss/RssData: strengths of all packets of a while, by its own clock
    ScanFormat{"*/RssData", "", "mac_address[]", "data[].rss"}
        .stampedBy("time_start_ns", 1e-9)
        .spanning("duration_ms"),
    // rf_msgs of two houses
    ScanFormat{"rf_msgs/WifiDataArray", "wifidata", "macaddress", "strength"},
    ScanFormat{"rf_msgs/WifiData", "", "macaddress", "strength"},
    ScanFormat{"rf_msgs/WifiNodeData", "", "macaddress", "strength"},
    ScanFormat{"rf_msgs/Wifi", "", "txmac", "rssi"},
    ScanFormat{"rf_msgs/AccessPoints", "aps", "mac", "rssi"},
    ScanFormat{"rf_msgs/Station", "", "mac", "rssi"},
    ScanFormat{"isaac_hw_msgs/WifiSignals", "signals", "bssid", "signal_dbm"},
    // wifi_localization of 2scholz, with an age; before that with a flag
    ScanFormat{"*/WifiState", "", "macs[]", "strengths[]"}.agedBy("ms[]", 1e-3),
    ScanFormat{"*/WifiState", "", "macs[]", "strengths[]"}.freshBy("changed_signal_strength[]"),
    ScanFormat{"wifi_scan/Fingerprint", "list", "address", "rssi"},
    ScanFormat{"wifi_scan/RSSI", "", "address", "rssi"},
    // wifi_lookup, wifi_localization, wifi_publisher: parts of the text of iwlist, without the sign
    ScanFormat{"*/WifiData", "HotSpots", "MAC", "dB"}.in(SignalUnit::kNegative),
    ScanFormat{"*/WifiData", "HotSpots", "address", "signal"}.in(SignalUnit::kNegative),
    ScanFormat{"*/wifi", "", "MAC", "dB"}.in(SignalUnit::kNegative),
    ScanFormat{"*/WifiData", "data", "mac_address", "ss"},  // wifi_tools
    ScanFormat{"wifi_sensor/RssiMulti", "data", "their_mac_addr", "rssi"},
    ScanFormat{"wifi_sensor/Rssi", "", "their_mac_addr", "rssi"},
    // wifi_scanner and its namesakes
    ScanFormat{"*/WifiMeasurement", "", "bssid", "rssi"}.stampedBy("stamp"),
    ScanFormat{"*/WifiScan", "", "bssid[]", "power[]"}.stampedBy("stamp"),
    ScanFormat{"*/WifiScan", "", "mac_address", "strength"},
    ScanFormat{"diagnostic_msgs/DiagnosticArray", "data", "mac", "rssi"},  // see scanInDiagnostics
    // CaBot: JSON in a text, each time all readings of the last second; or what scanInText reads
    ScanFormat{"std_msgs/String", "data", "mac", "rssi"}
        .stampedBy("timestamp", 1.0)
        .agedBy("last_seen_ms", 1e-3)
        .ofKind("type"),
};

/// Whether a format is for messages of a type.
bool isFor(const ScanFormat& format, std::string_view type);

/// Why no reading can be taken from messages of a type that is known; empty for other types.
std::string whyNoReadings(std::string_view type);

}  // namespace sfw
