#pragma once

#include <optional>
#include <string>

#include "files/csv_fields.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// A CSV of readings, row by row: with the columns of this package (stamp, x, y, bssid, rssi_dbm,
/// robot), of WiGLE (FirstSeen, MAC, RSSI, Type), or of Kismet's table of packets (ts_sec, ts_usec,
/// transmac, signal, phyname).
class ScanTable {
 public:
  /// @param needs_positions  a file without x and y is refused
  /// @throw InputError as CsvTable
  ScanTable(const std::string& file, bool needs_positions);

  bool hasPositions() const;

  bool next() { return table_.next(); }
  std::size_t mostRows() const { return table_.mostRows(); }
  std::string line() const { return table_.line(); }

  /// Reads this row. Without x and y the position stays as it is.
  std::optional<RowFault> read(Reading& reading) const;

 private:
  std::optional<RowFault> readTime(Reading& reading) const;
  std::optional<RowFault> readSignal(Reading& reading) const;
  std::optional<RowFault> faultOfRadio() const;

  CsvTable table_;
};

}  // namespace sfw
