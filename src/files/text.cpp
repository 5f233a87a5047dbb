#include "files/text.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <clocale>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <numeric>

#include "structure_from_wifi/input_error.h"

namespace sfw {

std::optional<double> parseNumber(std::string_view text) {
  static const locale_t kClassic = newlocale(LC_ALL_MASK, "C", nullptr);
  const std::string number(trimmed(text));
  char* end = nullptr;
  const double value = strtod_l(number.c_str(), &end, kClassic);
  if (number.empty() || end != number.c_str() + number.size()) {
    return std::nullopt;
  }
  return value;
}

std::optional<std::int64_t> parseNanoseconds(std::string_view seconds) {
  std::string_view digits = trimmed(seconds);
  const bool negative = !digits.empty() && digits.front() == '-';
  if (negative || (!digits.empty() && digits.front() == '+')) {
    digits.remove_prefix(1);
  }
  const std::size_t point = std::min(digits.find('.'), digits.size());
  const std::string_view whole = digits.substr(0, point);
  const std::string_view fraction = digits.substr(std::min(point + 1, digits.size()));
  const auto all_digits = [](std::string_view text) {
    return text.find_first_not_of("0123456789") == std::string_view::npos;
  };
  constexpr std::size_t kMostDigits = 10;
  constexpr std::size_t kPlaces = 9;
  if (whole.size() + fraction.size() == 0 || whole.size() > kMostDigits || !all_digits(whole) ||
      !all_digits(fraction)) {
    return std::nullopt;
  }
  std::int64_t magnitude = 0;
  for (const char digit : whole) {
    magnitude = magnitude * 10 + (digit - '0');
  }
  constexpr std::int64_t kMostSeconds = 9'000'000'000;  // in 63 bits of nanoseconds, with room
  if (magnitude > kMostSeconds) {
    return std::nullopt;
  }
  for (std::size_t place = 0; place < kPlaces; ++place) {
    magnitude = magnitude * 10 + (place < fraction.size() ? fraction[place] - '0' : 0);
  }
  magnitude += fraction.size() > kPlaces && fraction[kPlaces] >= '5' ? 1 : 0;
  return negative ? -magnitude : magnitude;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t at = text.find(separator);
    parts.push_back(text.substr(0, at));
    if (at == std::string_view::npos) {
      return parts;
    }
    text.remove_prefix(at + 1);
  }
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

namespace {

/// Bytes of the valid UTF-8 character that a text starts with; 0 if it starts with none.
std::size_t utf8Length(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const unsigned lead = byte(0);
  if (lead < 0x80) {
    return 1;
  }
  const std::size_t length = lead < 0xc2   ? 0
                             : lead < 0xe0 ? 2
                             : lead < 0xf0 ? 3
                             : lead < 0xf5 ? 4
                                           : 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) {
      return 0;
    }
  }
  // Spelt too long, half of a surrogate pair, or beyond the last character.
  const bool wrong = (lead == 0xe0 && byte(1) < 0xa0) || (lead == 0xed && byte(1) >= 0xa0) ||
                     (lead == 0xf0 && byte(1) < 0x90) || (lead == 0xf4 && byte(1) >= 0x90);
  return wrong ? 0 : length;
}

}  // namespace

std::string asUtf8(std::string_view text) {
  std::string valid;
  while (!text.empty()) {
    const std::size_t length = utf8Length(text);
    valid += length > 0 ? text.substr(0, length) : "?";
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return valid;
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
