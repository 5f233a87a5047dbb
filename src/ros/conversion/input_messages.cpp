#include "ros/conversion/input_messages.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "ros/conversion/cloud_points.h"
#include "ros/conversion/ros_settings.h"

namespace sfw {
namespace {

ros::Time stampOr(const ros::Time& stamp, const ros::Time& received) {
  return stamp.isZero() ? received : stamp;
}

/// The type of a message for people: a hostile name is cut short and holds no control characters.
std::string printableType(const AnyMessage& message) {
  constexpr std::size_t kLongest = 100;
  std::string type = message.type.substr(0, kLongest);
  std::replace_if(
      type.begin(), type.end(), [](unsigned char c) { return c <= ' ' || c > '~'; }, '?');
  return type.empty() ? "unknown" : type;
}

/// Rejects a message of a type that its input does not take.
Conversion rejectType(const AnyMessage& message, const std::string& taken) {
  return {{}, 1, "its messages are of type " + printableType(message) + ", and not " + taken};
}

template <class Message>
bool hasTypeOf(const AnyMessage& message) {
  return message.type == ros::message_traits::datatype<Message>();
}

/// Converts a message of one type.
/// @param taken  types that the input takes, in words
template <class Message>
Conversion convertAs(Conversion (*convert)(const Message&, const InputContext&),
                     const AnyMessage& any, const InputContext& context, const char* taken) {
  try {
    const std::optional<Message> message = any.as<Message>();
    if (!message) {
      return hasTypeOf<Message>(any)
                 ? Conversion{{}, 1, "its messages are of another version of " + printableType(any)}
                 : rejectType(any, taken);
    }
    return convert(*message, context);
  } catch (const std::exception& error) {
    return {{}, 1, "a message cannot be read: " + std::string(error.what())};
  }
}

}  // namespace

Conversion convertScan(const structure_from_wifi::WifiScan& scan, const InputContext& context) {
  constexpr std::size_t kMostReadings = 1000;  // far more than the readings of any radio
  constexpr double kOldestS = 3600.0;  // no cache of scans is older, and ros::Duration throws
  const std::size_t readings = std::min(scan.readings.size(), kMostReadings);
  const ros::Time stamp = stampOr(scan.header.stamp, context.received);
  Conversion conversion;
  for (std::size_t i = 0; i < readings; ++i) {
    const structure_from_wifi::ApReading& reading = scan.readings[i];
    const std::optional<Bssid> bssid = Bssid::parse(reading.bssid);
    const double age_s = reading.age_s;
    if (bssid && age_s >= 0.0 && age_s < std::min(kOldestS, stamp.toSec())) {
      conversion.observations.push_back(
          {stamp - ros::Duration(age_s),
           UnlocatedReading{*bssid, static_cast<double>(reading.rssi_dbm)}});
    }
  }
  conversion.rejected = scan.readings.size() - conversion.observations.size();
  if (conversion.rejected > 0) {
    conversion.problem = "bssid or age_s is malformed, or the scan has more than 1000 readings";
  }
  return conversion;
}

Conversion convertConnection(const wireless_msgs::Connection& connection,
                             const InputContext& context) {
  const std::optional<Bssid> bssid = Bssid::parse(connection.bssid);
  if (!bssid || connection.signal_level == 0) {
    return {{}, 0, "the radio is not associated"};
  }
  const UnlocatedReading reading{*bssid, static_cast<double>(connection.signal_level)};
  return {{{context.received, reading}}};
}

Conversion convertContact(const std_msgs::Bool& contact, const InputContext& context) {
  if (contact.data == 0) {
    return {};
  }
  const UnlocatedContacts ahead{context.antenna_frame, {{context.footprint_radius_m, 0.0, 0.0}}};
  return {{{context.received, ahead}}};
}

Conversion convertContactPoints(const sensor_msgs::PointCloud2& cloud,
                                const InputContext& context) {
  constexpr double kFarthestM = 2.0;
  try {
    const UnlocatedContacts contacts{withoutSlash(cloud.header.frame_id),
                                     nearPoints(cloud, kFarthestM)};
    Conversion conversion{{{stampOr(cloud.header.stamp, context.received), contacts}}};
    if (contacts.frame != cloud.header.frame_id) {
      conversion.problem = "frames of tf2 have no leading slash; '" + cloud.header.frame_id +
                           "' is taken as '" + contacts.frame + "'";
    }
    return conversion;
  } catch (const std::runtime_error& error) {
    return {{}, 1, "the cloud of contact points cannot be read: " + std::string(error.what())};
  }
}

Conversion convertReadings(const AnyMessage& message, const InputContext& context) {
  constexpr char kTaken[] = "structure_from_wifi/WifiScan or wireless_msgs/Connection";
  if (hasTypeOf<wireless_msgs::Connection>(message)) {
    return convertAs<wireless_msgs::Connection>(convertConnection, message, context, kTaken);
  }
  return convertAs<structure_from_wifi::WifiScan>(convertScan, message, context, kTaken);
}

Conversion convertAnyContact(const AnyMessage& message, const InputContext& context) {
  return convertAs<std_msgs::Bool>(convertContact, message, context, "std_msgs/Bool");
}

Conversion convertAnyContactPoints(const AnyMessage& message, const InputContext& context) {
  return convertAs<sensor_msgs::PointCloud2>(convertContactPoints, message, context,
                                             "sensor_msgs/PointCloud2");
}

}  // namespace sfw
