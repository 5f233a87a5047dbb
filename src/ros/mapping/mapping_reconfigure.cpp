// Settings of the mapping nodelet that dynamic_reconfigure changes, all in the mapping thread.

#include <exception>

#include "ros/mapping/mapping_nodelet.h"

namespace sfw {

void MappingNodelet::advertiseLiveSettings() {
  ros::NodeHandle node(getPrivateNodeHandle(), "live");
  node.setCallbackQueue(&slow_calls_);
  // The server starts with the parameters in its namespace, which may be those of an earlier node.
  toLive({config_, ros_settings_, scan_settings_, {}}).__toServer__(node);
  live_server_ =
      std::make_unique<dynamic_reconfigure::Server<structure_from_wifi::LiveConfig>>(node);
  live_server_->setCallback(
      [this](structure_from_wifi::LiveConfig& live, std::uint32_t) { changeSettings(live); });
}

void MappingNodelet::changeSettings(structure_from_wifi::LiveConfig& live) {
  const MappingSettings present{config_, ros_settings_, scan_settings_, {}};
  MappingSettings wanted = present;
  try {
    const std::vector<std::string> problems = takeLive(live, wanted);
    for (const std::string& problem : problems) {
      NODELET_ERROR_STREAM("The new settings are refused: " << problem);
    }
    if (!problems.empty()) {
      live = toLive(present);  // dynamic_reconfigure answers with these
      return;
    }
    takeSettings(live, wanted);
  } catch (const std::exception& error) {
    NODELET_ERROR_STREAM("The new settings are refused: " << error.what());
    live = toLive(present);
  }
}

void MappingNodelet::takeSettings(const structure_from_wifi::LiveConfig& live,
                                  const MappingSettings& wanted) {
  const ros::NodeHandle& node = getPrivateNodeHandle();
  bool has_changed = false, makes_another_map = false;
  const structure_from_wifi::LiveConfig present =
      toLive({config_, ros_settings_, scan_settings_, {}});
  forEachLiveSetting(present, wanted,
                     [&](const std::string& name, const auto& before, const auto& after) {
                       if (static_cast<std::decay_t<decltype(before)>>(after) != before) {
                         has_changed = true;
                         makes_another_map = makes_another_map || name.compare(0, 4, "ros/") != 0;
                         NODELET_INFO_STREAM(name << " is " << after << " now");
                       }
                     });
  if (makes_another_map) {
    mapper_->configure(wanted.config);
    refreshWhollyAnew();
  }
  if (!has_changed) {
    return;
  }
  // One by one, since other threads read other members meanwhile.
  struct Settings {
    Config& config;
    RosSettings& ros;
  } settings{config_, ros_settings_};
  forEachLiveSetting(live, settings, [&](const char* name, const auto& from, auto& to) {
    to = from;
    node.setParam(name, from);
  });
  next_autosave_ = ros::SteadyTime();  // by the new period
}

}  // namespace sfw
