#include "ros/conversion/scan_text.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "files/text.h"
#include "ros/conversion/scan_format.h"
#include "structure_from_wifi/bssid.h"

namespace sfw {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kDbm = "dBm";

/// The text between two others; nothing unless both are there.
std::optional<std::string_view> between(std::string_view text, std::string_view before,
                                        std::string_view after) {
  const std::size_t found = text.find(before);
  if (found == std::string_view::npos) {
    return std::nullopt;
  }
  const std::string_view rest = text.substr(found + before.size());
  const std::size_t end = rest.find(after);
  return end == std::string_view::npos ? std::nullopt : std::optional(rest.substr(0, end));
}

std::optional<double> numberBetween(std::string_view text, std::string_view before,
                                    std::string_view after) {
  const auto number = between(text, before, after);
  return number ? parseNumber(*number) : std::nullopt;
}

/// The address at the beginning of a text.
std::optional<Bssid> leadingBssid(std::string_view text) {
  constexpr std::size_t kLength = 17;
  return Bssid::parse(text.substr(0, kLength));
}

/// The access point that a line of `iw` or `iwlist` begins.
std::optional<Bssid> bssidOfCell(std::string_view line) {
  constexpr std::string_view kOfIw = "BSS ";
  constexpr std::string_view kCell = "Cell ";
  constexpr std::string_view kOfIwlist = "Address: ";
  if (line.substr(0, kOfIw.size()) == kOfIw) {
    return leadingBssid(line.substr(kOfIw.size()));
  }
  const std::size_t address = line.find(kOfIwlist);
  return trimmed(line).substr(0, kCell.size()) == kCell && address != std::string_view::npos
             ? leadingBssid(line.substr(address + kOfIwlist.size()))
             : std::nullopt;
}

template <std::size_t N>
void readNumber(std::string_view line, const std::string_view (&befores)[N], std::string_view after,
                const char* key, Json& cell) {
  for (const std::string_view before : befores) {
    if (const auto number = numberBetween(line, before, after)) {
      cell[key] = *number;
    }
  }
}

/// The cells of `iw scan` or `iwlist scan`.
Json cellsOf(std::string_view text) {
  constexpr std::string_view kStrength[] = {"signal: ", "Signal level=", "Signal level:"};
  constexpr std::string_view kAge[] = {"last seen: ", "Last beacon: "};
  Json cells = Json::array();
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (const std::optional<Bssid> bssid = bssidOfCell(line)) {
      cells.push_back(cells.size() < kMostReadings ? Json{{"mac", bssid->str()}} : Json());
    } else if (!cells.empty() && cells.back().is_object()) {
      readNumber(line, kStrength, kDbm, "rssi", cells.back());
      readNumber(line, kAge, "ms ago", "last_seen_ms", cells.back());
    }
  }
  return cells;
}

/// A line "bssid,ssid,channel,rssi,seconds,nanoseconds" of an ESP32. Names may hold commas.
Json readingOfLine(std::string_view line) {
  const std::optional<Bssid> bssid = Bssid::parse(line.substr(0, line.find(',')));
  std::vector<std::optional<double>> numbers;  // the last four, the last one first
  for (std::size_t comma = line.rfind(','); comma != std::string_view::npos && numbers.size() < 4;
       comma = line.rfind(',')) {
    numbers.push_back(parseNumber(line.substr(comma + 1)));
    line = line.substr(0, comma);
  }
  const bool is_one = bssid && numbers.size() == 4 && line.find(',') != std::string_view::npos &&
                      std::all_of(numbers.begin(), numbers.end(),
                                  [](const auto& number) { return number.has_value(); });
  constexpr double kNanosecond = 1e-9;
  return is_one ? Json{{"mac", bssid->str()},
                       {"rssi", *numbers[2]},
                       {"timestamp", *numbers[1] + kNanosecond * *numbers[0]}}
                : Json();
}

/// A member of an object; null without it, and if it is no object.
Json memberOf(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() ? *found : Json();
}

std::string textOf(const Json& value) {
  return value.is_string() ? value.get<std::string>() : std::string();
}

/// The value of the first of two keys that a status has; empty without one.
std::string valueOf(const Json& status, std::string_view key, std::string_view other_key) {
  for (const Json& value : memberOf(status, "values")) {
    const std::string name = textOf(memberOf(value, "key"));
    if (name == key || name == other_key) {
      return textOf(memberOf(value, "value"));
    }
  }
  return "";
}

}  // namespace

Json scanInText(std::string_view text) {
  Json readings = cellsOf(text);
  if (readings.empty()) {
    const Json reading = readingOfLine(trimmed(text));
    if (reading.is_null()) {
      return reading;
    }
    readings.push_back(reading);
  }
  return {{"data", readings}};
}

Json scanInDiagnostics(const Json& message) {
  Json readings = Json::array();
  for (const Json& status : memberOf(message, "status")) {
    const std::string bssid = valueOf(status, "bssid", "ap_hwaddr");
    const std::string rssi = valueOf(status, "signal", "signal_level");
    if (!bssid.empty()) {
      const Json reading{{"mac", bssid}, {"rssi", rssi.substr(0, rssi.find(kDbm))}};
      readings.push_back(readings.size() < kMostReadings ? reading : Json());
    }
  }
  return readings.empty() ? Json()
                          : Json{{"header", memberOf(message, "header")}, {"data", readings}};
}

}  // namespace sfw
