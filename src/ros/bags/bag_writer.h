#pragma once

#include <string>

#include "ros/conversion/ros_settings.h"
#include "simulation/simulated_recording.h"

namespace sfw {

/// Writes a simulated recording as a bag for the mapping nodelet. At each stamp the bag has the
/// transforms map -> odom -> antenna on /tf, then a scan on /wifi_scan. The file appears complete
/// or not at all.
/// @throw InputError naming the file if it cannot be written.
void writeBag(const std::string& file, const SimulatedRecording& recording,
              const RosSettings& frames);

}  // namespace sfw
