#pragma once

#include <string>
#include <vector>

#include "ros/conversion/scan_format.h"

namespace sfw {

/// The group `scan_format` in config/mapping.yaml: where the readings of a message type are that no
/// known format describes. ScanFormat says what the paths mean.
struct ScanSettings {
  std::string type;                    ///< package/Name; empty: none
  std::string readings;                ///< list of the readings
  std::string bssid;                   ///< path of the address, or an address
  std::string rssi;                    ///< path of the signal strength
  std::string unit = "dbm";            ///< of the strength: dbm, negative, quality or mbm
  std::string stamp = "header.stamp";  ///< path of the time
  std::string stamp_unit = "s";        ///< of a stamp that is a number: s, ms, us or ns
  std::string age;                     ///< path of the age at the stamp
  std::string age_unit = "s";          ///< as stamp_unit
};

/// Calls `visit(name, member)` for each setting.
template <class AnySettings, class Visitor>
void forEachScanSetting(AnySettings& settings, Visitor&& visit) {
  visit("scan_format/type", settings.type);
  visit("scan_format/readings", settings.readings);
  visit("scan_format/bssid", settings.bssid);
  visit("scan_format/rssi", settings.rssi);
  visit("scan_format/unit", settings.unit);
  visit("scan_format/stamp", settings.stamp);
  visit("scan_format/stamp_unit", settings.stamp_unit);
  visit("scan_format/age", settings.age);
  visit("scan_format/age_unit", settings.age_unit);
}

/// Every problem of the settings, one sentence each that starts with the setting's name.
std::vector<std::string> validate(const ScanSettings& settings);

/// The format that valid settings describe; it refers to their texts.
ScanFormat toScanFormat(const ScanSettings& settings);

}  // namespace sfw
