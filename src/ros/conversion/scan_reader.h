#pragma once

#include <ros/time.h>

#include "ros/conversion/any_message.h"
#include "ros/conversion/observation.h"
#include "ros/conversion/scan_format.h"

namespace sfw {

/// Takes the readings of a message by a format of its type.
///
/// At most kMostReadings are taken; the others are rejected. Readings without a usable address or
/// strength are rejected too. The time and memory that it takes are in proportion to the message.
///
/// @param own       format of the settings, before those of kScanFormats
/// @param received  time of a reading whose message has no usable stamp
/// @return a problem that names the type, if no format fits
/// @throw InputError if the message cannot be read
Conversion readScan(const AnyMessage& message, const ScanFormat& own, const ros::Time& received);

/// The type of a message for people: without control characters, and not too long.
std::string printableType(const AnyMessage& message);

}  // namespace sfw
