#include "files/scan_table.h"

#include <cmath>

namespace sfw {
namespace {

enum Column : std::size_t { kStamp, kX, kY, kBssid, kRssi, kMicroseconds, kType, kPhy, kRobot };

std::vector<CsvColumn> columnsOf(bool needs_positions) {
  const std::string advice = "; x and y may come from a file of the path: --path";
  return {{"stamp", {"timestamp", "time", "FirstSeen", "ts_sec"}},
          {"x", {}, needs_positions, advice},
          {"y", {}, needs_positions, advice},
          {"bssid", {"mac", "transmac", "sourcemac"}},
          {"rssi_dbm", {"rssi", "signal"}},
          {"ts_usec", {}, false},
          {"Type", {}, false},
          {"phyname", {}, false},
          {"robot", {}, false}};
}

}  // namespace

ScanTable::ScanTable(const std::string& file, bool needs_positions)
    : table_(file, columnsOf(needs_positions)) {
  if (table_.name(kRssi) == "signal" && table_.name(kStamp) != "ts_sec") {
    throw InputError(file +
                     ": line 1: the column 'rssi_dbm' is missing; 'signal' is read from "
                     "Kismet's packets only");
  }
}

bool ScanTable::hasPositions() const { return table_.has(kX) && table_.has(kY); }

std::optional<RowFault> ScanTable::read(Reading& reading) const {
  std::optional<RowFault> fault = faultOfRow(table_);
  if (!fault) {
    fault = faultOfRadio();
  }
  if (!fault) {
    fault = readTime(reading);
  }
  if (!fault && hasPositions()) {
    fault = readPosition(table_, kX, reading.antenna_in_map);
  }
  return fault ? fault : readSignal(reading);
}

/// WiGLE and Kismet also record other radios than WiFi.
std::optional<RowFault> ScanTable::faultOfRadio() const {
  if (table_.name(kStamp) == "FirstSeen" && table_.has(kType) && table_.field(kType) != "WIFI") {
    return faultOf(table_, kType, " is not WIFI");
  }
  if (table_.name(kStamp) == "ts_sec" && table_.has(kPhy) && table_.field(kPhy) != "IEEE802.11") {
    return faultOf(table_, kPhy, " is not IEEE802.11");
  }
  return std::nullopt;
}

std::optional<RowFault> ScanTable::readTime(Reading& reading) const {
  std::optional<RowFault> fault = readStamp(table_, kStamp, reading.stamp_ns);
  if (fault || !table_.has(kMicroseconds)) {
    return fault;
  }
  constexpr double kSecond = 1e6;
  double microseconds = 0.0;
  fault = readNumber(table_, kMicroseconds, 0.0, kSecond, microseconds);
  reading.stamp_ns += std::llround(microseconds * 1e3);
  return fault;
}

std::optional<RowFault> ScanTable::readSignal(Reading& reading) const {
  const std::optional<Bssid> bssid = Bssid::parse(table_.field(kBssid));
  if (!bssid) {
    return faultOf(table_, kBssid, " is malformed");
  }
  reading.bssid = *bssid;
  reading.robot = std::string(table_.field(kRobot));
  constexpr double kAbsurd = 1e5;  // Mapper checks the signals, and the notes name other units
  std::optional<RowFault> fault = readNumber(table_, kRssi, -kAbsurd, kAbsurd, reading.rssi_dbm);
  if (!fault && table_.name(kStamp) == "ts_sec" && reading.rssi_dbm == 0.0) {
    fault = faultOf(table_, kRssi, " is 0, where Kismet has no signal");
  }
  return fault;
}

}  // namespace sfw
