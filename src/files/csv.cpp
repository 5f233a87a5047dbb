#include "files/csv.h"

#include <algorithm>

#include "files/text.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// A longer field has lost its closing quote; the limit keeps reading linear.
constexpr std::size_t kLongestField = 65536;

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

bool startsWith(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

/// Whether a comma in a number may as well separate thousands: one to three digits before it, three
/// behind it.
bool maySeparateThousands(std::string_view number) {
  number.remove_prefix(startsWith(number, "-") || startsWith(number, "+") ? 1 : 0);
  const std::size_t comma = number.find(',');
  return comma >= 1 && comma <= 3 && number.size() == comma + 4 && number[0] != '0';
}

}  // namespace

CsvTable::CsvTable(std::string file, std::vector<CsvColumn> columns)
    : file_(std::move(file)), text_(readFile(file_)), column_(columns.size()) {
  constexpr std::string_view kUtf16[] = {"\xFF\xFE", "\xFE\xFF"};
  if (startsWith(text_, kUtf16[0]) || startsWith(text_, kUtf16[1])) {
    throw InputError(file_ + ": the file is UTF-16; save it as CSV in UTF-8");
  }
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // spreadsheets write it
  at_ = startsWith(text_, kByteOrderMark) ? kByteOrderMark.size() : 0;
  if (text_.find('\n') == std::string::npos) {
    std::replace(text_.begin(), text_.end(), '\r', '\n');  // line ends of old spreadsheets
  }
  readHeader(columns);
  findRowNames();
}

std::string_view CsvTable::physicalLine() const {
  return std::string_view(text_).substr(at_, std::min(text_.find('\n', at_), text_.size()) - at_);
}

std::size_t CsvTable::mostRows() const {
  return 1 + static_cast<std::size_t>(std::count(
                 text_.begin() + static_cast<std::ptrdiff_t>(std::min(at_, text_.size())),
                 text_.end(), '\n'));
}

bool CsvTable::next() {
  while (at_ < text_.size()) {
    readRow();
    const bool is_blank = std::all_of(fields_.begin(), fields_.end(),
                                      [](std::string_view field) { return field.empty(); });
    if (!is_blank || !problem_.empty()) {
      checkLength();
      return true;
    }
  }
  return false;
}

void CsvTable::checkLength() {
  std::size_t length = fields_.size();
  if (length <= width_ + row_names_ || may_have_more_fields_ || !problem_.empty()) {
    return;
  }
  while (length > 0 && fields_[length - 1].empty()) {  // separators at the end of a line
    --length;
  }
  if (length > width_ + row_names_) {
    problem_ =
        "a row has more fields than the header has columns; put quotes around a text with "
        "the separator in it";
  }
}

void CsvTable::readRow() {
  problem_.clear();
  fields_.clear();
  unescaped_.clear();
  line_ = next_line_;
  row_start_ = at_;
  const std::string_view line = physicalLine();
  if (line.find('"') != std::string_view::npos) {
    splitQuoted();
    return;
  }
  splitPlain(line);
  at_ += line.size() + 1;
  ++next_line_;
}

void CsvTable::splitPlain(std::string_view line) {
  if (separator_ != ' ') {
    for (std::size_t at = 0; at <= line.size();) {
      const std::size_t end = std::min(line.find(separator_, at), line.size());
      fields_.push_back(trimmed(line.substr(at, end - at)));
      at = end + 1;
    }
    return;
  }
  for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    fields_.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

std::size_t CsvTable::skipBlanks(std::size_t at) const {
  while (at < text_.size() && isBlank(text_[at]) &&
         text_[at] != (separator_ == ' ' ? 0 : separator_)) {
    ++at;
  }
  return at;
}

bool CsvTable::isFieldEnd(std::size_t at) const {
  return at >= text_.size() || text_[at] == '\n' || text_[at] == separator_ ||
         (separator_ == ' ' && isBlank(text_[at]));
}

/// The quote that ends a field; a doubled quote is part of it.
std::optional<std::size_t> CsvTable::closingQuote(std::size_t opening) const {
  std::size_t at = opening + 1;
  while (true) {
    at = text_.find('"', at);
    if (at == std::string::npos || at - opening > kLongestField) {
      return std::nullopt;
    }
    if (at + 1 == text_.size() || text_[at + 1] != '"') {
      break;
    }
    at += 2;
  }
  const bool is_end = isFieldEnd(at + 1) || isFieldEnd(skipBlanks(at + 1));
  return is_end ? std::optional(at) : std::nullopt;
}

void CsvTable::addQuoted(std::size_t opening, std::size_t closing) {
  const std::string_view field = std::string_view(text_).substr(opening + 1, closing - opening - 1);
  if (field.find('"') == std::string_view::npos) {
    fields_.push_back(trimmed(field));
    return;
  }
  std::string plain;
  for (std::size_t i = 0; i < field.size(); ++i) {
    plain += field[i];
    i += field[i] == '"' ? 1 : 0;
  }
  unescaped_.push_back(std::move(plain));
  fields_.push_back(trimmed(unescaped_.back()));
}

void CsvTable::splitQuoted() {
  const std::size_t line_end = std::min(text_.find('\n', at_), text_.size());
  std::size_t at = at_;
  while (true) {
    at = skipBlanks(at);
    if (at < text_.size() && text_[at] == '"') {
      const std::optional<std::size_t> closing = closingQuote(at);
      if (!closing) {
        problem_ = "a quote is not closed, in field " + std::to_string(fields_.size() + 1);
        at = line_end;
        break;
      }
      addQuoted(at, *closing);
      at = skipBlanks(*closing + 1);
    } else {
      std::size_t end = at;
      while (!isFieldEnd(end)) {
        ++end;
      }
      fields_.push_back(trimmed(std::string_view(text_).substr(at, end - at)));
      at = end;
    }
    at = separator_ == ' ' ? skipBlanks(at) : at;
    if (at >= text_.size() || text_[at] == '\n') {
      break;
    }
    at += separator_ == ' ' ? 0 : 1;
  }
  next_line_ += 1 + static_cast<std::size_t>(
                        std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                   text_.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  at_ = at + 1;
}

std::string CsvTable::number(std::size_t i) const {
  std::string text(field(i));
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos || text.find(',', comma + 1) != std::string::npos ||
      text.find('.') != std::string::npos || (separator_ == ',' && maySeparateThousands(text))) {
    return text;
  }
  text[comma] = '.';
  return text;
}

std::string csvField(const std::string& text) {
  const bool has_blank = !text.empty() && (text.front() == ' ' || text.back() == ' ');
  if (!has_blank && text.find_first_of(",;\t\"\r\n") == std::string::npos) {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + "\"";
}

}  // namespace sfw
