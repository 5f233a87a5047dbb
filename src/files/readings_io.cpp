#include "structure_from_wifi/readings_io.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "files/text.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// A CSV text with a header, row by row.
class Table {
 public:
  /// @throw InputError if a column is missing.
  Table(const std::string& file, const std::vector<std::string>& columns)
      : file_(file), text_(readFile(file)), rest_(text_) {
    if (trimmed(rest_).empty()) {
      throw InputError(file_ + ": the file is empty");
    }
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // spreadsheets write it
    rest_.remove_prefix(rest_.rfind(kByteOrderMark, 0) == 0 ? kByteOrderMark.size() : 0);
    const std::string_view header = nextLine();
    const std::vector<std::string_view> names = split(header, ',');
    if (names.size() == 1 && header.find(columns.front()) != std::string_view::npos &&
        header.find_first_of(";\t") != std::string_view::npos) {
      throw InputError(file_ + ": line 1: columns must be separated by commas");
    }
    for (const std::string& column : columns) {
      const auto found = std::find_if(names.begin(), names.end(), [&](std::string_view name) {
        return trimmed(name) == column;
      });
      if (found == names.end()) {
        throw InputError(file_ + ": line 1: the column '" + column + "' is missing");
      }
      column_.push_back(static_cast<std::size_t>(found - names.begin()));
    }
  }

  /// Moves to the next row that is not blank; false at the end.
  bool next() {
    while (!rest_.empty()) {
      const std::string_view line = trimmed(nextLine());
      if (!line.empty()) {
        fields_ = split(line, ',');
        return true;
      }
    }
    return false;
  }

  /// Text of the i-th requested column; empty if the row is too short.
  std::string_view field(std::size_t i) const {
    return column_[i] < fields_.size() ? trimmed(fields_[column_[i]]) : std::string_view();
  }

  std::string line() const { return "line " + std::to_string(line_); }

 private:
  std::string_view nextLine() {
    const std::size_t end = rest_.find('\n');
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++line_;
    return line;
  }

  std::string file_;
  std::string text_;
  std::string_view rest_;
  std::size_t line_ = 0;
  std::vector<std::size_t> column_;
  std::vector<std::string_view> fields_;
};

/// A reason for counting, and the offending text for the message.
struct Fault {
  std::string reason;
  std::string detail;
};

/// Largest stamp [s] whose nanoseconds fit 63 bits with room to spare.
constexpr double kMaxStamp = 4e9;

std::optional<Fault> readNumber(const Table& table, std::size_t column, const std::string& name,
                                double low, double high, double& value) {
  const std::string text(table.field(column));
  const std::optional<double> number = parseNumber(text);
  if (!number) {
    return Fault{name + " is not a number", name + " '" + text + "'"};
  }
  if (!std::isfinite(*number)) {
    return Fault{name + " is not finite", name + " '" + text + "'"};
  }
  if (*number < low || *number > high) {
    return Fault{name + " is out of range", name + " '" + text + "'"};
  }
  value = *number;
  return std::nullopt;
}

/// Reads x from the given column and y from the next one.
std::optional<Fault> readPosition(const Table& table, std::size_t x, Position& position) {
  constexpr double kFar = 1e6;  // metres; no building reaches farther
  std::optional<Fault> fault = readNumber(table, x, "x", -kFar, kFar, position.x());
  if (!fault) {
    fault = readNumber(table, x + 1, "y", -kFar, kFar, position.y());
  }
  return fault;
}

/// Adds the likely unit to a fault of a stamp that is too large for seconds since 1970.
Fault withUnit(Fault fault, const std::string& stamp) {
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

std::optional<Fault> readPlace(const Table& table, std::int64_t& stamp_ns, Position& position) {
  double stamp_s = 0.0;
  std::optional<Fault> fault = readNumber(table, 0, "stamp", -kMaxStamp, kMaxStamp, stamp_s);
  if (fault) {
    return withUnit(*fault, std::string(table.field(0)));
  }
  // A double holds present-day stamps in seconds only to a quarter of a microsecond.
  const std::optional<std::int64_t> exact_ns = parseNanoseconds(table.field(0));
  stamp_ns = exact_ns ? *exact_ns : std::llround(stamp_s * 1e9);
  return readPosition(table, 1, position);
}

std::optional<Fault> readReading(const Table& table, Reading& reading) {
  std::optional<Fault> fault = readPlace(table, reading.stamp_ns, reading.antenna_in_map);
  if (fault) {
    return fault;
  }
  const std::string_view text = table.field(3);
  const std::optional<Bssid> bssid = Bssid::parse(text);
  if (!bssid) {
    return Fault{"bssid is malformed", "bssid '" + std::string(text) + "'"};
  }
  reading.bssid = *bssid;
  constexpr double kAbsurd = 1e5;  // Mapper checks the signals, and the notes name other units
  return readNumber(table, 4, "rssi_dbm", -kAbsurd, kAbsurd, reading.rssi_dbm);
}

InputError unusable(const std::string& file, const Table& table, const Fault& fault) {
  return InputError(file + ": " + table.line() + ": " + fault.reason + ": " + fault.detail);
}

/// "stamp,x,y", to the nanosecond and to Mapper's 0.1 mm.
std::string placeCsv(std::int64_t stamp_ns, const Position& position) {
  constexpr std::int64_t kSecond = 1000000000;
  return formatted("%s%lld.%09lld,%.4f,%.4f", stamp_ns < 0 ? "-" : "",
                   std::llabs(stamp_ns / kSecond), std::llabs(stamp_ns % kSecond), position.x(),
                   position.y());
}

}  // namespace

ReadingFile readReadings(const std::string& file) {
  Table table(file, {"stamp", "x", "y", "bssid", "rssi_dbm"});
  ReadingFile result;
  while (table.next()) {
    Reading reading;
    if (const std::optional<Fault> fault = readReading(table, reading)) {
      SkippedRows& skipped = result.skipped[fault->reason];
      if (skipped.count++ == 0) {
        skipped.first = table.line() + ": " + fault->detail;
      }
      continue;
    }
    result.readings.push_back(reading);
  }
  if (result.readings.empty()) {
    std::string why = result.skipped.empty() ? "it has no rows" : "";
    for (const auto& [reason, skipped] : result.skipped) {
      why += (why.empty() ? "" : "; ") + reason + " (" + skipped.first + ")";
    }
    throw InputError(file + ": no row can be used: " + why);
  }
  return result;
}

std::vector<Contact> readContacts(const std::string& file) {
  Table table(file, {"stamp", "x", "y"});
  std::vector<Contact> contacts;
  while (table.next()) {
    Contact contact;
    if (const std::optional<Fault> fault =
            readPlace(table, contact.stamp_ns, contact.point_in_map)) {
      throw unusable(file, table, *fault);
    }
    contacts.push_back(contact);
  }
  return contacts;
}

std::vector<Position> readWayPoints(const std::string& file) {
  Table table(file, {"x", "y"});
  std::vector<Position> way_points;
  while (table.next()) {
    Position way_point = Position::Zero();
    if (const std::optional<Fault> fault = readPosition(table, 0, way_point)) {
      throw unusable(file, table, *fault);
    }
    way_points.push_back(way_point);
  }
  return way_points;
}

std::string readingsCsv(const std::vector<Reading>& readings) {
  std::string text = "stamp,x,y,bssid,rssi_dbm\n";
  for (const Reading& reading : readings) {
    text += placeCsv(reading.stamp_ns, reading.antenna_in_map) +
            formatted(",%s,%.2f\n", reading.bssid.str().c_str(), reading.rssi_dbm);
  }
  return text;
}

std::string contactsCsv(const std::vector<Contact>& contacts) {
  std::string text = "stamp,x,y\n";
  for (const Contact& contact : contacts) {
    text += placeCsv(contact.stamp_ns, contact.point_in_map) + "\n";
  }
  return text;
}

}  // namespace sfw
