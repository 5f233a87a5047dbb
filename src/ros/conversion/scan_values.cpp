#include "ros/conversion/scan_values.h"

#include <cmath>
#include <cstdint>
#include <string>

#include "files/text.h"

namespace sfw {

std::optional<double> numberOf(const nlohmann::json* value) {
  if (value != nullptr && value->is_number()) {
    return value->get<double>();
  }
  return value != nullptr && value->is_string() ? parseNumber(value->get_ref<const std::string&>())
                                                : std::nullopt;
}

std::optional<Bssid> bssidOf(const nlohmann::json* value) {
  if (value != nullptr && value->is_string()) {
    return Bssid::parse(trimmed(value->get_ref<const std::string&>()));
  }
  constexpr std::size_t kBytes = 6;
  if (value == nullptr || !value->is_array() || value->size() != kBytes) {
    return std::nullopt;
  }
  std::string text;
  for (const nlohmann::json& byte : *value) {
    if (!byte.is_number_integer()) {
      return std::nullopt;
    }
    const auto low_byte = static_cast<unsigned>(byte.get<std::int64_t>() & 0xff);
    text += (text.empty() ? "" : ":") + formatted("%02x", low_byte);
  }
  return Bssid::parse(text);
}

double toDbm(double value, SignalUnit unit) {
  switch (unit) {
    case SignalUnit::kNegative:
      return -std::abs(value);
    case SignalUnit::kQuality:
      return value / 2.0 - 100.0;
    case SignalUnit::kHundredthDbm:
      return value / 100.0;
    case SignalUnit::kDbm:
      break;
  }
  return value;
}

std::optional<ros::Time> timeOfParts(const nlohmann::json& parts) {
  const auto part = [&](const char* name, const char* other) {
    const auto found = parts.contains(name) ? parts.find(name) : parts.find(other);
    return found != parts.end() && found->is_number_integer() ? found->get<std::int64_t>() : 0;
  };
  constexpr std::int64_t kLatest = 4000000000;  // a stamp plus an age must fit 32 bits
  const std::int64_t seconds = part("secs", "sec");
  const std::int64_t nanoseconds = part("nsecs", "nanosec");
  if (seconds < 0 || seconds > kLatest || nanoseconds < 0 || nanoseconds >= 1000000000 ||
      seconds + nanoseconds == 0) {
    return std::nullopt;
  }
  return ros::Time(static_cast<std::uint32_t>(seconds), static_cast<std::uint32_t>(nanoseconds));
}

}  // namespace sfw
