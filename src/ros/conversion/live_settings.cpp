#include "ros/conversion/live_settings.h"

#include <type_traits>

namespace sfw {

structure_from_wifi::LiveConfig toLive(const MappingSettings& settings) {
  structure_from_wifi::LiveConfig live = structure_from_wifi::LiveConfig::__getDefault__();
  forEachLiveSetting(live, settings, [](const char*, auto& to, const auto& from) {
    to = static_cast<std::decay_t<decltype(to)>>(from);
  });
  return live;
}

std::vector<std::string> takeLive(const structure_from_wifi::LiveConfig& live,
                                  MappingSettings& settings) {
  MappingSettings wanted = settings;
  forEachLiveSetting(live, wanted, [](const char*, const auto& from, auto& to) { to = from; });
  std::vector<std::string> problems = validate(wanted.config);
  const std::vector<std::string> of_ros = validate(wanted.ros);
  problems.insert(problems.end(), of_ros.begin(), of_ros.end());
  if (problems.empty()) {
    forEachLiveSetting(live, settings, [](const char*, const auto& from, auto& to) { to = from; });
  }
  return problems;
}

}  // namespace sfw
