#include "files/csv_fields.h"

#include <cmath>
#include <cstdlib>

#include "files/date_time.h"
#include "files/text.h"

namespace sfw {
namespace {

/// Largest stamp [s] whose nanoseconds fit 63 bits with room to spare.
constexpr double kMaxStamp = 4e9;
constexpr std::int64_t kMaxStampNs = 4'000'000'000'000'000'000;

/// Metres; no map projection has larger numbers.
constexpr double kFarthest = 1e8;

/// Adds the likely unit to a fault of a stamp that is too large for seconds since 1970.
RowFault withUnit(RowFault fault, const std::string& stamp) {
  constexpr double kThousand = 1e3;
  const double size = std::abs(parseNumber(stamp).value_or(0.0));
  double largest = kMaxStamp;
  for (const char* unit : {"milliseconds", "microseconds", "nanoseconds"}) {
    if (size > largest && size <= largest * kThousand) {
      fault.reason += std::string(", and looks like ") + unit + ": convert it to seconds";
    }
    largest *= kThousand;
  }
  return fault;
}

}  // namespace

RowFault faultOf(const CsvTable& table, std::size_t column, const std::string& what) {
  const std::string& name = table.name(column);
  return {name + what, name + " " + inQuotes(table.field(column))};
}

std::optional<RowFault> readNumber(const CsvTable& table, std::size_t column, double low,
                                   double high, double& value) {
  const std::string_view field = table.field(column);
  const bool has_comma = field.find(',') != std::string_view::npos;
  const std::optional<double> number = parseNumber(has_comma ? table.number(column) : field);
  if (!number) {
    return faultOf(
        table, column,
        has_comma ? " is not a number: its comma may separate thousands" : " is not a number");
  }
  if (!std::isfinite(*number)) {
    return faultOf(table, column, " is not finite");
  }
  if (*number < low || *number > high) {
    return faultOf(table, column, " is out of range");
  }
  value = *number;
  return std::nullopt;
}

std::optional<RowFault> readPosition(const CsvTable& table, std::size_t x, Position& position) {
  std::optional<RowFault> fault = readNumber(table, x, -kFarthest, kFarthest, position.x());
  if (!fault) {
    fault = readNumber(table, x + 1, -kFarthest, kFarthest, position.y());
  }
  return fault;
}

std::optional<RowFault> readStamp(const CsvTable& table, std::size_t column,
                                  std::int64_t& stamp_ns) {
  // A double holds present-day stamps in seconds only to a quarter of a microsecond.
  const std::string text = table.number(column);
  const std::optional<std::int64_t> exact_ns = parseNanoseconds(text);
  if (exact_ns && std::abs(*exact_ns) <= kMaxStampNs) {
    stamp_ns = *exact_ns;
    return std::nullopt;
  }
  double stamp_s = 0.0;
  std::optional<RowFault> fault = readNumber(table, column, -kMaxStamp, kMaxStamp, stamp_s);
  if (!fault) {
    stamp_ns = std::llround(stamp_s * 1e9);
    return std::nullopt;
  }
  const std::optional<std::int64_t> date = parseDateTime(table.field(column));
  stamp_ns = date.value_or(0);
  return date ? std::nullopt : std::optional(withUnit(*fault, text));
}

std::optional<RowFault> faultOfRow(const CsvTable& table) {
  return table.problem().empty() ? std::nullopt
                                 : std::optional(RowFault{table.problem(), "the row is left out"});
}

std::optional<RowFault> readPlace(const CsvTable& table, std::int64_t& stamp_ns,
                                  Position& position) {
  std::optional<RowFault> fault = faultOfRow(table);
  if (!fault) {
    fault = readStamp(table, 0, stamp_ns);
  }
  return fault ? fault : readPosition(table, 1, position);
}

std::string robotOf(const CsvTable& table) {
  constexpr std::size_t kRobot = 3;
  return std::string(table.field(kRobot));
}

InputError unusable(const CsvTable& table, const RowFault& fault) {
  return InputError(table.file() + ": " + table.line() + ": " + fault.reason + ": " + fault.detail);
}

std::vector<CsvColumn> placeColumns() {
  return {{"stamp", {"timestamp", "time"}}, {"x", {"tx"}}, {"y", {"ty"}}, {"robot", {}, false}};
}

}  // namespace sfw
