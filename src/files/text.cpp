#include "files/text.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <clocale>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>

#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

const locale_t kClassic = newlocale(LC_ALL_MASK, "C", nullptr);

bool isDigits(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Reads the usual forms of numbers, many times as fast as strtod.
/// @return nothing for other forms, and if the standard library cannot do it.
std::optional<double> parsePlainNumber([[maybe_unused]] std::string_view text) {
#ifdef __cpp_lib_to_chars
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc() && rest == end) {
    return value;
  }
#endif
  return std::nullopt;
}

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

}  // namespace

std::optional<double> parseNumber(std::string_view text) {
  if (const std::optional<double> plain = parsePlainNumber(text)) {
    return plain;
  }
  const std::string number(trimmed(text));
  char* end = nullptr;
  const double value = strtod_l(number.c_str(), &end, kClassic);
  if (number.empty() || end != number.c_str() + number.size()) {
    return std::nullopt;
  }
  return value;
}

std::string exactText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", std::numeric_limits<double>::digits10, value);
  if (parseNumber(text) != value) {
    std::snprintf(text, sizeof text, "%.*g", std::numeric_limits<double>::max_digits10, value);
  }
  return text;
}

std::optional<std::int64_t> parseNanoseconds(std::string_view seconds) {
  std::string_view text = trimmed(seconds);
  const bool negative = text.substr(0, 1) == "-";
  if (negative || text.substr(0, 1) == "+") {
    text.remove_prefix(1);
  }
  const std::size_t point = std::min(text.find('.'), text.size());
  const std::string_view whole = text.substr(0, point);
  const std::string_view fraction = text.substr(std::min(point + 1, text.size()));
  constexpr std::size_t kPlaces = 9;
  constexpr std::size_t kMostWhole = kPlaces + 1;
  if ((whole.empty() && fraction.empty()) || whole.size() > kMostWhole || !isDigits(whole) ||
      !isDigits(fraction)) {
    return std::nullopt;
  }
  std::uint64_t nanoseconds = 0;
  const auto append = [&](char digit) {
    nanoseconds = 10 * nanoseconds + static_cast<std::uint64_t>(digit - '0');
  };
  std::for_each(whole.begin(), whole.end(), append);
  for (std::size_t i = 0; i < kPlaces; ++i) {
    append(i < fraction.size() ? fraction[i] : '0');
  }
  constexpr std::uint64_t kMost = 9'000'000'000'999'999'999;  // in 63 bits, with room
  if (nanoseconds > kMost) {
    return std::nullopt;
  }
  const std::int64_t rounded = static_cast<std::int64_t>(nanoseconds) +
                               (fraction.size() > kPlaces && fraction[kPlaces] >= '5' ? 1 : 0);
  return negative ? -rounded : rounded;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && isBlank(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && isBlank(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row.back();
}

std::string asUtf8(const std::string& text) {
  using Json = nlohmann::json;
  const std::string valid = Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
  return Json::parse(valid).get<std::string>();
}

std::string inQuotes(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::string shown(text.substr(0, kLongest));
  std::replace_if(
      shown.begin(), shown.end(), [](unsigned char c) { return c < ' ' || c == '\x7f'; }, '?');
  return "'" + asUtf8(shown) + (text.size() > kLongest ? "..." : "") + "'";
}

std::string printable(const std::string& text, std::size_t longest) {
  std::string shown = text.substr(0, longest);
  std::replace_if(
      shown.begin(), shown.end(), [](unsigned char c) { return c <= ' ' || c > '~'; }, '?');
  return shown;
}

std::string withPrefix(const std::string& prefix, const std::string& lines) {
  std::istringstream all(lines);
  std::string text;
  for (std::string line; std::getline(all, line);) {
    text += (text.empty() ? "" : "\n") + prefix + line;
  }
  return text;
}

std::string readFile(const std::string& file) {
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::string text;
  std::array<char, 65536> chunk{};
  while (stream.read(chunk.data(), chunk.size()) || stream.gcount() > 0) {
    text.append(chunk.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (!stream.eof()) {  // it did not open, or is a directory: that opens, but does not read
    throw InputError(file + ": cannot be read: " + std::strerror(errno));
  }
  return text;
}

}  // namespace sfw
