#include "ros/conversion/input_messages.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "files/text.h"
#include "ros/conversion/cloud_points.h"
#include "ros/conversion/message_layout.h"
#include "ros/conversion/message_values.h"
#include "ros/conversion/robot_topics.h"
#include "ros/conversion/ros_settings.h"
#include "ros/conversion/scan_reader.h"

namespace sfw {
namespace {

ros::Time stampOr(const ros::Time& stamp, const ros::Time& received) {
  return stamp.isZero() ? received : stamp;
}

/// Rejects a message of a type that its input does not take.
Conversion rejectType(const AnyMessage& message, const std::string& taken) {
  return rejection("its messages are of type " + printableType(message) + ", and not " + taken);
}

Conversion rejectDamaged(const AnyMessage& message, const std::exception& error) {
  return rejection("a message of type " + printableType(message) +
                   " cannot be read: " + error.what());
}

template <class Message>
bool hasTypeOf(const AnyMessage& message) {
  return message.type == ros::message_traits::datatype<Message>();
}

/// Deserializes a message; nothing if it is of another version of the type.
/// @throw std::exception if the bytes are no such message
template <class Message>
std::optional<Message> readAs(const AnyMessage& any) {
  namespace traits = ros::message_traits;
  if (any.md5 != traits::md5sum<Message>()) {
    return std::nullopt;
  }
  // roscpp would make room for as many elements as the bytes tell of, so they are checked first.
  readValues(MessageLayout(any.type, traits::definition<Message>()), any.bytes, {});
  // IStream only reads, but has no constructor for constant bytes.
  ros::serialization::IStream stream(const_cast<std::uint8_t*>(any.bytes.data()),
                                     static_cast<std::uint32_t>(any.bytes.size()));
  Message message;
  ros::serialization::deserialize(stream, message);
  return message;
}

/// Why a message on a topic of several robots belongs to none of them.
std::string whyOfNoRobot(const std::vector<std::string>& antenna_frames) {
  std::string namespaces;
  for (const std::string& name : robotNames(antenna_frames)) {
    namespaces += (namespaces.empty() ? "" : " or ") + name;
  }
  return "a message without a frame does not name its robot; publish it in the namespace of its "
         "robot, " +
         namespaces;
}

/// Converts a message of one type.
/// @param taken  types that the input takes, in words
template <class Message>
Conversion convertAs(Conversion (*convert)(const Message&, const InputContext&),
                     const AnyMessage& any, const InputContext& context, const char* taken) {
  try {
    if (!hasTypeOf<Message>(any)) {
      return rejectType(any, taken);
    }
    const std::optional<Message> message = readAs<Message>(any);
    return message ? convert(*message, context)
                   : rejection("its messages are of another version of " + printableType(any));
  } catch (const std::exception& error) {
    return rejectDamaged(any, error);
  }
}

}  // namespace

Conversion convertContact(const std_msgs::Bool& contact, const InputContext& context) {
  if (contact.data == 0) {
    return {};
  }
  if (context.antenna_frame.empty()) {
    return rejection(whyOfNoRobot(context.antenna_frames));
  }
  const UnlocatedContacts ahead{context.antenna_frame, {{context.footprint_radius_m, 0.0, 0.0}}};
  return {{{context.received, ahead}}};
}

Conversion convertContactPoints(const sensor_msgs::PointCloud2& cloud,
                                const InputContext& context) {
  constexpr double kFarthestM = 2.0;
  try {
    if (withoutSlash(cloud.header.frame_id).empty()) {
      throw std::runtime_error("it has no frame_id");
    }
    const UnlocatedContacts contacts{withoutSlash(cloud.header.frame_id),
                                     nearPoints(cloud, kFarthestM)};
    Conversion conversion{{{stampOr(cloud.header.stamp, context.received), contacts}}};
    conversion.problem = slashProblem(cloud.header.frame_id);
    return conversion;
  } catch (const std::runtime_error& error) {
    return rejection("the cloud of contact points cannot be read: " + std::string(error.what()));
  }
}

Conversion withRobot(Conversion conversion, const InputContext& context) {
  constexpr std::size_t kLongest = 100;
  const std::vector<std::string>& frames = context.antenna_frames;
  if (frames.size() < 2 || conversion.observations.empty()) {
    return conversion;
  }
  const bool names_robot =
      std::find(frames.begin(), frames.end(), conversion.frame) != frames.end();
  const std::string robot = names_robot ? conversion.frame : context.antenna_frame;
  if (robot.empty()) {
    const std::string reason = conversion.frame.empty()
                                   ? whyOfNoRobot(frames)
                                   : "the frame of a scan, '" +
                                         printable(conversion.frame, kLongest) +
                                         "', is none of ros/antenna_frames";
    conversion.problem.clear();  // what hides all readings is told first
    conversion.reject(reason, conversion.observations.size());
    conversion.observations.clear();
    return conversion;
  }
  for (Observation& observation : conversion.observations) {
    observation.robot = robot;
  }
  return conversion;
}

Conversion convertReadings(const AnyMessage& message, const InputContext& context) {
  try {
    return withRobot(readScan(message, context.scan_format, context.received), context);
  } catch (const std::exception& error) {
    return rejectDamaged(message, error);
  }
}

Conversion convertAnyContact(const AnyMessage& message, const InputContext& context) {
  return convertAs<std_msgs::Bool>(convertContact, message, context, "std_msgs/Bool");
}

Conversion convertAnyContactPoints(const AnyMessage& message, const InputContext& context) {
  return convertAs<sensor_msgs::PointCloud2>(convertContactPoints, message, context,
                                             "sensor_msgs/PointCloud2");
}

}  // namespace sfw
