#pragma once

#include <ros/serialization.h>

#include <cstdint>
#include <string>
#include <vector>

namespace sfw {

/// A message of any type, as it comes from a connection or a bag.
struct AnyMessage {
  std::string type;                 ///< package/Name
  std::string md5;                  ///< of its definition
  std::string definition;           ///< text of the message file, then those of the types in it
  std::vector<std::uint8_t> bytes;  ///< serialized
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

}  // namespace sfw
