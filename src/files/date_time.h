#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace sfw {

/// Parses a date and time as in ISO 8601, "2024-05-31 12:34:56.25" or "2024-05-31T12:34:56+02:00",
/// to nanoseconds since 1970. A time without a zone is UTC.
/// @return nothing if the text is no such time in the years 1970 to 2099
std::optional<std::int64_t> parseDateTime(std::string_view text);

}  // namespace sfw
