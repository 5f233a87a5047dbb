#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sfw {

/// The number that the whole text spells ('.' as decimal point in any locale; blanks around it
/// are ignored), or nothing. NaN and infinities are returned as such.
std::optional<double> parseNumber(std::string_view text);

/// Text without leading and trailing blanks.
std::string_view trimmed(std::string_view text);

/// The parts between separators; always at least one.
std::vector<std::string_view> split(std::string_view text, char separator);

/// The whole file. @throw InputError naming it.
std::string readFile(const std::string& file);

}  // namespace sfw
