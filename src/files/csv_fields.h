#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "files/csv.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Why a row of a CSV cannot be used.
struct RowFault {
  std::string reason;  ///< counts rows alike
  std::string detail;  ///< the offending text
};

/// "x is out of range", with the text of the column.
RowFault faultOf(const CsvTable& table, std::size_t column, const std::string& what);

/// What CsvTable finds wrong with this row.
std::optional<RowFault> faultOfRow(const CsvTable& table);

/// Reads a finite number between two limits.
std::optional<RowFault> readNumber(const CsvTable& table, std::size_t column, double low,
                                   double high, double& value);

/// Reads x from the given column and y from the next one [m].
std::optional<RowFault> readPosition(const CsvTable& table, std::size_t x, Position& position);

/// Reads seconds, or a date and time as parseDateTime does.
std::optional<RowFault> readStamp(const CsvTable& table, std::size_t column,
                                  std::int64_t& stamp_ns);

/// The columns stamp, x, y and, if there are several robots, robot, for readPlace and robotOf.
std::vector<CsvColumn> placeColumns();

/// Reads a row of a table whose first columns are placeColumns.
std::optional<RowFault> readPlace(const CsvTable& table, std::int64_t& stamp_ns,
                                  Position& position);

/// The robot of a row in such a table; empty without that column.
std::string robotOf(const CsvTable& table);

/// The error for a file in which every row must be right.
InputError unusable(const CsvTable& table, const RowFault& fault);

}  // namespace sfw
