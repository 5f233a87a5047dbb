#include "ros/conversion/scan_format.h"

#include <algorithm>
#include <iterator>

namespace sfw {
namespace {

struct UselessType {
  std::string_view type;
  const char* reason;
};

constexpr char kNoStrength[] = "tell no signal strength; use another topic of their node";
constexpr char kNoBssid[] = "name no access point; give its address as scan_format/bssid";

constexpr UselessType kUselessTypes[] = {
    {"wireless_msgs/Scan", kNoStrength},
    {"wireless_msgs/Network", kNoStrength},
    {"*/WifiInfo", kNoStrength},
    {"*/EnvSensor", kNoBssid},
    {"*/UserData", kNoBssid},
    {"kaiaai_msgs/WifiState", kNoBssid},
    {"std_msgs/Int8", kNoBssid},
    {"std_msgs/Int16", kNoBssid},
    {"std_msgs/Int32", kNoBssid},
    {"std_msgs/Float32", kNoBssid},
    {"std_msgs/Float64", kNoBssid},
};

bool matches(std::string_view pattern, std::string_view type) {
  if (pattern.substr(0, 2) != "*/") {
    return pattern == type;
  }
  const std::string_view name = pattern.substr(1);
  return type.size() > name.size() && type.substr(type.size() - name.size()) == name;
}

}  // namespace

bool isFor(const ScanFormat& format, std::string_view type) {
  return !format.type.empty() && matches(format.type, type);
}

std::string whyNoReadings(std::string_view type) {
  const auto* useless =
      std::find_if(std::begin(kUselessTypes), std::end(kUselessTypes),
                   [&](const UselessType& known) { return matches(known.type, type); });
  return useless == std::end(kUselessTypes) ? "" : useless->reason;
}

}  // namespace sfw
