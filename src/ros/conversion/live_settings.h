#pragma once

#include <structure_from_wifi/LiveConfig.h>

#include <string>
#include <vector>

#include "ros/conversion/ros_settings.h"

namespace sfw {

/// Calls `visit(name, live member, setting)` for each setting that may change while mapping goes
/// on. cfg/Live.cfg lists the same ones for dynamic_reconfigure.
template <class AnyLive, class AnySettings, class Visitor>
void forEachLiveSetting(AnyLive& live, AnySettings& settings, Visitor&& visit) {
  auto& belief = settings.config.belief;
  visit("ros/publish_rate", live.publish_rate, settings.ros.publish_rate_hz);
  visit("ros/cpu_share", live.cpu_share, settings.ros.cpu_share);
  visit("ros/autosave_period", live.autosave_period, settings.ros.autosave_period_s);
  visit("belief/free_threshold", live.free_threshold, belief.free_threshold);
  visit("belief/occupied_threshold", live.occupied_threshold, belief.occupied_threshold);
  visit("belief/rim", live.rim, belief.rim);
  visit("k_visibility/window", live.window, settings.config.k_visibility.window);
}

/// The live settings in the form of dynamic_reconfigure.
structure_from_wifi::LiveConfig toLive(const MappingSettings& settings);

/// Takes live settings over, if all of them can be used.
/// @return every problem, one sentence each; with one, the settings stay as they are.
std::vector<std::string> takeLive(const structure_from_wifi::LiveConfig& live,
                                  MappingSettings& settings);

}  // namespace sfw
