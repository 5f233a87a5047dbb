#pragma once

#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sfw {

/// The number that the whole text spells ('.' as decimal point in any locale; blanks around it
/// are ignored), or nothing. NaN and infinities are returned as such.
std::optional<double> parseNumber(std::string_view text);

/// The number with as few digits as read back the same.
std::string exactText(double value);

/// Nanoseconds in seconds that are spelt as a plain decimal number ("-1.25"): exact, rounded at the
/// tenth place. Nothing for any other notation, nor beyond +-9e9 s, more than ten digits included.
std::optional<std::int64_t> parseNanoseconds(std::string_view seconds);

/// Text without leading and trailing blanks.
std::string_view trimmed(std::string_view text);

/// The parts between separators; always at least one.
std::vector<std::string_view> split(std::string_view text, char separator);

/// Levenshtein's distance: insertions, deletions and substitutions that turn `a` into `b`.
std::size_t editDistance(std::string_view a, std::string_view b);

/// The text with U+FFFD for every byte that is no part of valid UTF-8.
std::string asUtf8(const std::string& text);

/// Text by a format of printf.
template <class... Arguments>
std::string formatted(const char* format, Arguments... arguments) {
  const int length = std::snprintf(nullptr, 0, format, arguments...);
  std::string text(static_cast<std::size_t>(length) + 1, '\0');
  std::snprintf(text.data(), text.size(), format, arguments...);
  text.pop_back();
  return text;
}

/// The whole file. @throw InputError naming it.
std::string readFile(const std::string& file);

}  // namespace sfw
