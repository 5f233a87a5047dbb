#pragma once

#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

namespace sfw {

/// Parses a number with '.' as decimal point in any locale. Blanks around it are ignored.
/// @return nothing if the text is no number; NaN and infinities are numbers here
std::optional<double> parseNumber(std::string_view text);

/// Formats a number with the fewest digits that read back as the same number.
std::string exactText(double value);

/// Parses seconds in plain decimal notation ("-1.25") to nanoseconds, rounded at the tenth place.
/// @return nothing for another notation, beyond +-9e9 s, or for more than ten digits before the
/// point
std::optional<std::int64_t> parseNanoseconds(std::string_view seconds);

/// Removes leading and trailing blanks.
std::string_view trimmed(std::string_view text);

/// Levenshtein's distance: insertions, deletions and substitutions that turn `a` into `b`.
std::size_t editDistance(std::string_view a, std::string_view b);

/// Replaces every byte that is no part of valid UTF-8 by U+FFFD.
std::string asUtf8(const std::string& text);

/// A text for people, with '?' for blanks, control characters and all that is not ASCII.
/// @param longest  [bytes]; the rest is cut
std::string printable(const std::string& text, std::size_t longest);

/// A text of a file in quotes, for people: on one line, without control characters, and not long.
std::string inQuotes(std::string_view text);

/// Puts a prefix before each line of a text.
std::string withPrefix(const std::string& prefix, const std::string& lines);

/// Formats as printf.
template <class... Arguments>
std::string formatted(const char* format, Arguments... arguments) {
  const int length = std::snprintf(nullptr, 0, format, arguments...);
  std::string text(static_cast<std::size_t>(length) + 1, '\0');
  std::snprintf(text.data(), text.size(), format, arguments...);
  text.pop_back();
  return text;
}

/// Reads a whole file. @throw InputError naming it.
std::string readFile(const std::string& file);

}  // namespace sfw
