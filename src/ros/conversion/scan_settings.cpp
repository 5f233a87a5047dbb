#include "ros/conversion/scan_settings.h"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "base/validation.h"
#include "structure_from_wifi/bssid.h"

namespace sfw {
namespace {

struct NamedUnit {
  const char* name;
  SignalUnit unit;
};

constexpr NamedUnit kSignalUnits[] = {{"dbm", SignalUnit::kDbm},
                                      {"negative", SignalUnit::kNegative},
                                      {"quality", SignalUnit::kQuality},
                                      {"mbm", SignalUnit::kHundredthDbm}};

struct NamedTime {
  const char* name;
  double seconds;
};

constexpr NamedTime kTimeUnits[] = {{"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}};

template <class Units>
const auto* unitOf(const Units& units, const std::string& name) {
  const auto* found = std::find_if(std::begin(units), std::end(units),
                                   [&](const auto& unit) { return unit.name == name; });
  return found == std::end(units) ? nullptr : found;
}

/// Names of fields joined by dots, each perhaps with "[]".
bool isPath(std::string text) {
  for (std::size_t brackets = 0; (brackets = text.find("[]", brackets)) != std::string::npos;) {
    const std::size_t end = brackets + 2;
    if (brackets == 0 || (end < text.size() && text[end] != '.')) {
      return false;
    }
    text.erase(brackets, 2);
  }
  return text.find("..") == std::string::npos && (text.empty() || text.front() != '.') &&
         (text.empty() || text.back() != '.') &&
         std::all_of(text.begin(), text.end(),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '.'; });
}

std::string quoted(const std::string& text) { return "'" + text + "'"; }

void addUnitProblems(const ScanSettings& settings, Problems& problems) {
  if (settings.unit == "percent") {
    problems.add(
        "scan_format/unit must not be percent, which each driver scales in its own way; quality is "
        "that of NetworkManager, quality / 2 - 100 dBm");
  } else {
    problems.require(unitOf(kSignalUnits, settings.unit) != nullptr, "scan_format/unit",
                     quoted(settings.unit), "dbm, negative, quality or mbm");
  }
  for (const auto& [name, unit] : {std::pair("scan_format/stamp_unit", settings.stamp_unit),
                                   std::pair("scan_format/age_unit", settings.age_unit)}) {
    problems.require(unitOf(kTimeUnits, unit) != nullptr, name, quoted(unit), "s, ms, us or ns");
  }
}

}  // namespace

std::vector<std::string> validate(const ScanSettings& settings) {
  Problems problems;
  const std::size_t slash = settings.type.find('/');
  const bool has_type = !settings.type.empty();
  const bool is_full_name = slash != std::string::npos && slash > 0 &&
                            slash + 1 < settings.type.size() && slash == settings.type.rfind('/');
  problems.require(!has_type || is_full_name, "scan_format/type", quoted(settings.type),
                   "package/Name of a message");
  if (has_type) {
    problems.require(!settings.bssid.empty(), "scan_format/bssid", "''",
                     "the path of an address, or an address");
    problems.require(!settings.rssi.empty(), "scan_format/rssi", "''", "the path of a strength");
  } else {
    problems.require(settings.bssid.empty() && settings.rssi.empty(), "scan_format/type", "''",
                     "the type of the message with these fields");
  }
  for (const auto& [name, path] : {std::pair("scan_format/readings", settings.readings),
                                   std::pair("scan_format/bssid", settings.bssid),
                                   std::pair("scan_format/rssi", settings.rssi),
                                   std::pair("scan_format/stamp", settings.stamp),
                                   std::pair("scan_format/age", settings.age)}) {
    problems.require(isPath(path) || Bssid::parse(path).has_value(), name, quoted(path),
                     "names of fields joined by dots, as networks.mac or macs[]");
  }
  addUnitProblems(settings, problems);
  return problems.list();
}

ScanFormat toScanFormat(const ScanSettings& settings) {
  ScanFormat format{settings.type, settings.readings, settings.bssid, settings.rssi};
  format.unit = unitOf(kSignalUnits, settings.unit)->unit;
  format.stamp = settings.stamp;
  format.stamp_unit_s = unitOf(kTimeUnits, settings.stamp_unit)->seconds;
  format.age = settings.age;
  format.age_unit_s = unitOf(kTimeUnits, settings.age_unit)->seconds;
  return format;
}

}  // namespace sfw
