#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sfw {

/// A column that the reader of a CSV asks for.
struct CsvColumn {
  std::string name;
  std::vector<std::string> other_names = {};  ///< of other programs, the preferred one first
  bool is_required = true;
  std::string advice = {};  ///< ends the error if the column is missing
};

/// A CSV by RFC 4180 with a header, row by row.
///
/// Reads what spreadsheets, R, Python and WiGLE write: quoted fields, also with separators, quotes
/// and line ends; columns separated by commas, semicolons, tabs or blanks; a byte-order mark; CRLF;
/// row names without a column in the header; a line before the header ("sep=;", "WigleWifi-1.4").
/// Names of columns are compared without case. Blanks around a field are removed.
///
/// A row whose quotes cannot be understood has a problem(); the next row starts on the next line.
/// Linear in the size of the file, which is held in memory.
class CsvTable {
 public:
  /// Reads the file and its header.
  /// @throw InputError naming the file if it cannot be read, is empty or UTF-16, or lacks a
  /// required column; then the columns that it has are listed.
  CsvTable(std::string file, std::vector<CsvColumn> columns);
  CsvTable(const CsvTable&) = delete;
  CsvTable& operator=(const CsvTable&) = delete;

  /// Moves to the next row that is not blank; false at the end.
  bool next();

  /// At least the number of rows that are left. Linear in the size of the file.
  std::size_t mostRows() const;

  /// Whether the file has the i-th column asked for.
  bool has(std::size_t i) const { return column_[i].has_value(); }

  /// The one of its names under which the i-th column was found, or the first one.
  const std::string& name(std::size_t i) const { return names_[i]; }

  /// Text of the i-th column in this row; empty if there is none. Valid until the next row.
  std::string_view field(std::size_t i) const {
    return column_[i] && *column_[i] + row_names_ < fields_.size()
               ? fields_[*column_[i] + row_names_]
               : std::string_view();
  }

  /// The same for a number. A decimal comma is a point here. In a table with commas between its
  /// columns, "1,234" stays as it is: the comma may separate thousands.
  std::string number(std::size_t i) const;

  /// What is wrong with the quotes or the length of this row; empty if nothing is.
  const std::string& problem() const { return problem_; }

  /// "line 7", where this row begins.
  std::string line() const { return "line " + std::to_string(line_); }

  const std::string& file() const { return file_; }

 private:
  void skipPreface();
  void readHeader(const std::vector<CsvColumn>& columns);
  std::size_t namesIn(const std::vector<CsvColumn>& columns);
  void findColumns(const std::vector<CsvColumn>& columns);
  void findRowNames();
  [[noreturn]] void refuseHeader(const CsvColumn& missing) const;
  void checkLength();

  std::string_view physicalLine() const;
  void readRow();
  void splitPlain(std::string_view line);
  void splitQuoted();
  std::optional<std::size_t> closingQuote(std::size_t opening) const;
  std::size_t skipBlanks(std::size_t at) const;
  bool isFieldEnd(std::size_t at) const;
  void addQuoted(std::size_t opening, std::size_t closing);

  std::string file_;
  std::string text_;
  std::size_t row_start_ = 0;  // of this row
  std::size_t at_ = 0;         // where the next row begins
  std::size_t next_line_ = 1;  // its line
  std::size_t line_ = 1;
  char separator_ = ',';
  std::size_t width_ = 0;             // columns of the header
  std::size_t row_names_ = 0;         // fields before the first column of the header
  bool may_have_more_fields_ = true;  // further fields cannot have moved a column asked for
  std::vector<std::optional<std::size_t>> column_;
  std::vector<std::string> names_;
  std::vector<std::string_view> fields_;
  std::deque<std::string> unescaped_;  // fields that had doubled quotes
  std::string problem_;
};

/// A text as a field of a CSV by RFC 4180, in quotes if it needs them.
std::string csvField(const std::string& text);

}  // namespace sfw
