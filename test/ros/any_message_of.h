#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>

#include "ros/conversion/any_message.h"

namespace sfw {

/// A message as a connection or a bag holds it.
template <class Message>
AnyMessage anyMessageOf(const Message& message) {
  namespace traits = ros::message_traits;
  AnyMessage any{traits::datatype<Message>(), traits::md5sum<Message>(),
                 traits::definition<Message>(),
                 std::vector<std::uint8_t>(ros::serialization::serializationLength(message))};
  ros::serialization::OStream stream(any.bytes.data(),
                                     static_cast<std::uint32_t>(any.bytes.size()));
  ros::serialization::serialize(stream, message);
  return any;
}

}  // namespace sfw
