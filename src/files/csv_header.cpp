#include <algorithm>
#include <cctype>
#include <iterator>
#include <tuple>

#include "files/csv.h"
#include "files/text.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

constexpr char kSeparators[] = {',', ';', '\t', ' '};

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

}  // namespace

/// Skips blank lines, and a line that programs write before the header.
void CsvTable::skipPreface() {
  while (at_ < text_.size()) {
    const std::string_view line = trimmed(physicalLine());
    if (!line.empty() && line.rfind("sep=", 0) != 0 && line.rfind("WigleWifi-", 0) != 0) {
      at_ = line[0] == '#' ? text_.find('#', at_) + 1 : at_;  // numpy puts it before the header
      return;
    }
    at_ += physicalLine().size() + 1;
    ++next_line_;
  }
  throw InputError(file_ + ": the file is empty");
}

void CsvTable::readHeader(const std::vector<CsvColumn>& columns) {
  skipPreface();
  const std::size_t start = at_;
  const std::size_t line = next_line_;
  std::tuple<std::size_t, std::size_t> most{0, 0};
  char best = kSeparators[0];
  for (const char separator : kSeparators) {
    std::tie(at_, next_line_, separator_) = std::make_tuple(start, line, separator);
    readRow();
    // Without any name found, the columns are told that the likeliest separator makes.
    const std::tuple<std::size_t, std::size_t> found{namesIn(columns), fields_.size()};
    if (found > most && (std::get<0>(found) > std::get<0>(most) || separator != ' ')) {
      most = found;
      best = separator;
    }
  }
  std::tie(at_, next_line_, separator_) = std::make_tuple(start, line, best);
  readRow();
  findColumns(columns);
}

/// The number of columns asked for that a header has.
std::size_t CsvTable::namesIn(const std::vector<CsvColumn>& columns) {
  std::vector<std::string> header;
  std::transform(fields_.begin(), fields_.end(), std::back_inserter(header), lowerCase);
  const auto is_there = [&](const std::string& name) {
    return std::find(header.begin(), header.end(), lowerCase(name)) != header.end();
  };
  return static_cast<std::size_t>(
      std::count_if(columns.begin(), columns.end(), [&](const CsvColumn& column) {
        return is_there(column.name) ||
               std::any_of(column.other_names.begin(), column.other_names.end(), is_there);
      }));
}

void CsvTable::findColumns(const std::vector<CsvColumn>& columns) {
  if (!problem_.empty()) {
    throw InputError(file_ + ": " + line() + ": " + problem_);
  }
  std::vector<std::string> header;
  std::transform(fields_.begin(), fields_.end(), std::back_inserter(header), lowerCase);
  width_ = header.size();
  std::vector<bool> is_asked_for(width_, false);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    names_.push_back(columns[i].name);
    auto found = std::find(header.begin(), header.end(), lowerCase(columns[i].name));
    for (const std::string& name : columns[i].other_names) {
      if (found == header.end()) {
        found = std::find(header.begin(), header.end(), lowerCase(name));
        names_.back() = found == header.end() ? names_.back() : name;
      }
    }
    if (found == header.end()) {
      if (columns[i].is_required) {
        refuseHeader(columns[i]);
      }
      continue;
    }
    if (std::find(found + 1, header.end(), *found) != header.end()) {
      throw InputError(file_ + ": " + line() + ": the column '" + *found + "' is there twice");
    }
    column_[i] = static_cast<std::size_t>(found - header.begin());
    is_asked_for[*column_[i]] = true;
  }
  // A stray separator in a text moves the columns behind it, and only those.
  may_have_more_fields_ = std::is_partitioned(is_asked_for.begin(), is_asked_for.end(),
                                              [](bool asked_for) { return asked_for; });
}

void CsvTable::refuseHeader(const CsvColumn& missing) const {
  constexpr std::size_t kMostListed = 20;
  std::string list;
  for (std::size_t i = 0; i < std::min(fields_.size(), kMostListed); ++i) {
    list += (i == 0 ? "" : ", ") + inQuotes(fields_[i]);
  }
  list += fields_.size() > kMostListed ? ", ..." : "";
  throw InputError(file_ + ": " + line() + ": the column '" + missing.name +
                   "' is missing; the file has " + list + missing.advice);
}

/// R writes the names of rows without a column in the header: each row has a field more than the
/// header, and the first one is quoted or counts the rows.
void CsvTable::findRowNames() {
  constexpr int kRows = 10;
  const auto start = std::make_tuple(at_, next_line_);
  bool all_have_names = false;
  for (int row = 1; row <= kRows && next(); ++row) {
    all_have_names =
        fields_.size() == width_ + 1 && !fields_.back().empty() &&
        (text_[row_start_] == '"' || (separator_ != ',' && fields_[0] == std::to_string(row)));
    if (!all_have_names) {
      break;
    }
  }
  row_names_ = all_have_names ? 1 : 0;
  std::tie(at_, next_line_) = start;
}

}  // namespace sfw
