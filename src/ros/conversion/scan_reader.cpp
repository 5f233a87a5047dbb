#include "ros/conversion/scan_reader.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "files/text.h"
#include "ros/conversion/field_path.h"
#include "ros/conversion/message_layout.h"
#include "ros/conversion/message_values.h"
#include "ros/conversion/ros_settings.h"
#include "ros/conversion/scan_text.h"
#include "ros/conversion/scan_values.h"

namespace sfw {
namespace {

using Json = nlohmann::json;

constexpr char kText[] = "std_msgs/String";
constexpr char kDiagnostics[] = "diagnostic_msgs/DiagnosticArray";
constexpr char kFrame[] = "header.frame_id";
constexpr double kHour = 3600.0;  // [s]; no cache of scans is older

/// Makes readings of the values of one message.
class ScanReader {
 public:
  ScanReader(const ScanFormat& format, const Json& message, const ros::Time& received)
      : format_(format),
        message_(message),
        received_(received),
        literal_(Bssid::parse(format.bssid)),
        bssid_(format.bssid),
        rssi_(format.rssi),
        stamp_(format.stamp),
        age_(format.age),
        span_(format.span_ms),
        fresh_(format.fresh),
        kind_(format.kind),
        frame_(kFrame) {}

  Conversion read() {
    const auto all = readings();
    const bool is_cut = all.size() > kMostReadings;  // readValues puts nulls for what is too much
    for (const auto& [reading, index] : all) {
      if (conversion_.observations.size() == kMostReadings || (is_cut && reading->is_null())) {
        conversion_.reject("the message has more than " + std::to_string(kMostReadings) +
                           " readings");
      } else {
        take(*reading, index);
      }
    }
    const Json* frame = frame_.find(message_, 0);
    if (frame != nullptr && frame->is_string()) {
      const std::string& given = frame->get_ref<const std::string&>();
      conversion_.frame = withoutSlash(given);
      conversion_.problem = conversion_.problem.empty() ? slashProblem(given) : conversion_.problem;
    }
    return std::move(conversion_);
  }

 private:
  /// Each reading, with its index in lists beside one another.
  std::vector<std::pair<const Json*, std::size_t>> readings() const {
    std::vector<std::pair<const Json*, std::size_t>> readings;
    if (!format_.readings.empty()) {
      for (const Json* reading : FieldPath(format_.readings).elements(message_)) {
        readings.emplace_back(reading, 0);
      }
      return readings;
    }
    const FieldPath& counted = bssid_.hasList() ? bssid_ : rssi_;
    const std::size_t count = counted.hasList() ? counted.length(message_) : 1;
    for (std::size_t i = 0; i < count; ++i) {
      readings.emplace_back(&message_, i);
    }
    return readings;
  }

  void take(const Json& reading, std::size_t index) {
    const auto value = [&](const FieldPath& path) { return find(path, reading, index); };
    const Json* kind = value(kind_);
    if (kind != nullptr && kind->is_string() && kind->get_ref<const std::string&>() != "WiFi") {
      return;
    }
    const Json* fresh = value(fresh_);
    if (fresh != nullptr && (*fresh == false || *fresh == 0)) {
      return conversion_.reject("the driver marks readings as old");
    }
    const std::optional<Bssid> bssid = literal_ ? literal_ : bssidOf(value(bssid_));
    const std::optional<double> rssi = strengthOf(value(rssi_));
    if (format_.is_link && (!bssid || !rssi)) {
      conversion_.problem = "the radio is not associated";
    } else if (!bssid) {
      conversion_.reject("a BSSID is malformed");
    } else if (!rssi) {
      conversion_.reject("a signal strength is 0 or missing");
    } else if (const std::optional<ros::Time> stamp = stampOf(reading, index)) {
      conversion_.observations.push_back({*stamp, UnlocatedReading{*bssid, *rssi}});
    } else {
      conversion_.reject("a reading has no usable time or age");
    }
  }

  const Json* find(const FieldPath& path, const Json& reading, std::size_t index) const {
    if (path.empty()) {
      return nullptr;
    }
    const Json* value = path.find(reading, index);
    return value != nullptr ? value : path.find(message_, index);
  }

  /// The strength [dBm]; of several values the mean, which does not grow with their number.
  std::optional<double> strengthOf(const Json* value) const {
    if (value == nullptr || !value->is_array()) {
      const std::optional<double> number = numberOf(value);
      return number && (*number != 0.0 || format_.has_zero_dbm)
                 ? std::optional(toDbm(*number, format_.unit))
                 : std::nullopt;
    }
    double sum = 0.0;
    std::size_t count = 0;
    for (const Json& element : *value) {
      const std::optional<double> number = numberOf(&element);
      if (number && *number != 0.0) {
        sum += toDbm(*number, format_.unit);
        ++count;
      }
    }
    return count > 0 ? std::optional(sum / static_cast<double>(count)) : std::nullopt;
  }

  /// The time of a reading; nothing if its age cannot be, or the clock does not run yet.
  std::optional<ros::Time> stampOf(const Json& reading, std::size_t index) const {
    ros::Time stamp = received_;
    for (const Json* from : {&reading, &message_}) {
      if (const std::optional<ros::Time> given = timeOf(stamp_.find(*from, index))) {
        stamp = *given;
        break;
      }
    }
    const std::optional<double> span_ms = numberOf(find(span_, reading, index));
    if (span_ms && *span_ms > 0.0 && *span_ms < 1e3 * kHour) {
      stamp += ros::Duration(*span_ms / 2e3);
    }
    const Json* age = find(age_, reading, index);
    const double age_s = age != nullptr ? numberOf(age).value_or(-1.0) * format_.age_unit_s : 0.0;
    const bool can_be = age_s >= 0.0 && age_s < std::min(kHour, stamp.toSec());
    return can_be ? std::optional(stamp - ros::Duration(age_s)) : std::nullopt;
  }

  /// A time, unless it is zero. A number is a time only within an hour of the receipt, since the
  /// clock of its sender may be another one.
  std::optional<ros::Time> timeOf(const Json* value) const {
    if (value != nullptr && value->is_object()) {
      return timeOfParts(*value);
    }
    const std::optional<double> number = numberOf(value);
    const double seconds = number ? *number * format_.stamp_unit_s : 0.0;
    if (!(seconds > 0.0 && std::abs(seconds - received_.toSec()) < kHour)) {
      return std::nullopt;
    }
    return ros::Time(seconds);
  }

  const ScanFormat& format_;
  const Json& message_;
  const ros::Time received_;
  const std::optional<Bssid> literal_;
  const FieldPath bssid_, rssi_, stamp_, age_, span_, fresh_, kind_, frame_;
  Conversion conversion_;
};

/// The first field that a format needs and a message lacks; empty if it has all.
std::string missingField(const ScanFormat& format, const MessageLayout& layout) {
  const MessageFields* reading = &layout.root();
  if (!format.readings.empty()) {
    reading = FieldPath(format.readings).listIn(layout);
    if (reading == nullptr) {
      return std::string(format.readings) + "[]";
    }
  }
  for (const std::string_view path : {format.bssid, format.rssi, format.age, format.fresh}) {
    const FieldPath field(path);
    if (!field.empty() && !Bssid::parse(path) && !field.isIn(layout, *reading) &&
        !field.isIn(layout, layout.root())) {
      return std::string(path);
    }
  }
  return "";
}

std::set<std::string> namesIn(const ScanFormat& format) {
  std::set<std::string> names = {"sec", "nanosec"};  // of a time of ROS 2, which is a message
  for (const std::string_view path :
       {format.readings, format.bssid, format.rssi, format.stamp, format.age, format.span_ms,
        format.fresh, format.kind, std::string_view(kFrame)}) {
    FieldPath(path).addNames(names);
  }
  return names;
}

Conversion problem(const AnyMessage& message, const std::string& what) {
  return rejection("its messages are of type " + printableType(message) + ", " + what);
}

/// The formats for a message; that of the settings alone, if there is one.
std::vector<const ScanFormat*> formatsOf(const AnyMessage& message, const ScanFormat& own) {
  if (isFor(own, message.type)) {
    return {&own};
  }
  std::vector<const ScanFormat*> formats;
  for (const ScanFormat& format : kScanFormats) {
    if (isFor(format, message.type)) {
      formats.push_back(&format);
    }
  }
  return formats;
}

/// Reads JSON in the text of a message, or another text that holds a scan.
/// @param is_known  whether the format is one of kScanFormats
Conversion readText(const AnyMessage& message, const MessageLayout& layout,
                    const ScanFormat& format, bool is_known, const ros::Time& received) {
  const Json content = readValues(layout, message.bytes, {"data"});
  const auto found = content.find("data");
  const std::string text =
      found != content.end() && found->is_string() ? found->get<std::string>() : std::string();
  constexpr bool kThrows = false;
  Json json = Json::parse(text, nullptr, kThrows);
  if (is_known && json.is_discarded()) {
    json = scanInText(text);
  }
  if (!json.is_object()) {
    return problem(message, "and its text is no JSON object" +
                                std::string(is_known ? " and no output of iw or iwlist" : ""));
  }
  const bool has_list =
      FieldPath(format.readings).empty() || FieldPath(format.readings).find(json, 0) != nullptr;
  if (!has_list) {
    return problem(message, "and its JSON has no list '" + std::string(format.readings) +
                                "'; describe it as scan_format");
  }
  return ScanReader(format, json, received).read();
}

/// Reads a scan in the keys of diagnostics.
Conversion readDiagnostics(const AnyMessage& message, const MessageLayout& layout,
                           const ScanFormat& format, const ros::Time& received) {
  const Json scan = scanInDiagnostics(readValues(
      layout, message.bytes, {"header", "stamp", "frame_id", "status", "values", "key", "value"}));
  return scan.is_null() ? problem(message, "and none of its statuses has the key bssid")
                        : ScanReader(format, scan, received).read();
}

}  // namespace

std::string printableType(const AnyMessage& message) {
  constexpr std::size_t kLongest = 100;
  const std::string type = printable(message.type, kLongest);
  return type.empty() ? "unknown" : type;
}

Conversion readScan(const AnyMessage& message, const ScanFormat& own, const ros::Time& received) {
  constexpr std::size_t kMostBytes = 4 * 1024 * 1024;
  const std::vector<const ScanFormat*> formats = formatsOf(message, own);
  if (formats.empty()) {
    const std::string reason = whyNoReadings(message.type);
    return problem(message, reason.empty() ? "which is unknown; describe it as scan_format"
                                           : "which " + reason);
  }
  if (message.bytes.size() > kMostBytes) {
    return problem(message, "and one has more than 4 MiB");
  }
  if (message.definition.empty()) {
    return problem(message, "and their publisher does not send its definition");
  }
  const MessageLayout layout(message.type, message.definition);
  const ScanFormat& first = *formats.front();
  const bool is_known = &first != &own;
  if (message.type == kText) {
    return readText(message, layout, first, is_known, received);
  }
  if (message.type == kDiagnostics && is_known) {
    return readDiagnostics(message, layout, first, received);
  }
  std::string missing;
  for (const ScanFormat* format : formats) {
    const std::string lacks = missingField(*format, layout);
    if (lacks.empty()) {
      const Json values = readValues(layout, message.bytes, namesIn(*format));
      return ScanReader(*format, values, received).read();
    }
    missing = missing.empty() ? lacks : missing;
  }
  return problem(message, "which has no field " + missing + "; describe it as scan_format");
}

}  // namespace sfw
