#pragma once

#include <ros/serialization.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sfw {

/// A message of any type, as it comes from a connection or a bag.
struct AnyMessage {
  std::string type;                 ///< package/Name
  std::string md5;                  ///< of its definition
  std::string definition;           ///< text of the message file, then those of the types in it
  std::vector<std::uint8_t> bytes;  ///< serialized

  /// Deserializes a message whose type was known when this was compiled.
  /// @return nothing if it is of another type or another version of the type
  /// @throw std::exception if the bytes are no such message
  template <class Message>
  std::optional<Message> as() const;
};

/// Copies a topic_tools::ShapeShifter or a rosbag::MessageInstance.
template <class Source>
AnyMessage toAnyMessage(const Source& source) {
  AnyMessage message{source.getDataType(), source.getMD5Sum(), source.getMessageDefinition(),
                     std::vector<std::uint8_t>(source.size())};
  ros::serialization::OStream stream(message.bytes.data(),
                                     static_cast<std::uint32_t>(message.bytes.size()));
  source.write(stream);
  return message;
}

template <class Message>
std::optional<Message> AnyMessage::as() const {
  namespace traits = ros::message_traits;
  if (type != traits::datatype<Message>() || md5 != traits::md5sum<Message>()) {
    return std::nullopt;
  }
  // IStream only reads, but has no constructor for constant bytes.
  ros::serialization::IStream stream(const_cast<std::uint8_t*>(bytes.data()),
                                     static_cast<std::uint32_t>(bytes.size()));
  Message message;
  ros::serialization::deserialize(stream, message);
  return message;
}

}  // namespace sfw
