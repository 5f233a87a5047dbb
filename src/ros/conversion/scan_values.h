#pragma once

#include <ros/time.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "ros/conversion/scan_format.h"
#include "structure_from_wifi/bssid.h"

namespace sfw {

/// Read a value of a message; a nullptr has none.
/// @{

/// A number, or a text that is one.
std::optional<double> numberOf(const nlohmann::json* value);

/// An address as text, or as six bytes.
std::optional<Bssid> bssidOf(const nlohmann::json* value);

/// A time of ROS 1 or 2 as an object; nothing if it is zero or cannot be.
std::optional<ros::Time> timeOfParts(const nlohmann::json& parts);
/// @}

/// A signal strength [dBm].
double toDbm(double value, SignalUnit unit);

}  // namespace sfw
