#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <topic_tools/shape_shifter.h>

#include <boost/make_shared.hpp>
#include <cstdint>
#include <vector>

namespace sfw {

/// A message as the mapping nodelet receives it. Within one process it is not copied then, so its
/// owners tell whether the nodelet is done with it.
template <class Message>
boost::shared_ptr<topic_tools::ShapeShifter> shapeOf(const Message& message) {
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  const auto size = static_cast<std::uint32_t>(bytes.size());
  ros::serialization::OStream out(bytes.data(), size);
  ros::serialization::serialize(out, message);
  auto shape = boost::make_shared<topic_tools::ShapeShifter>();
  shape->morph(ros::message_traits::md5sum(message), ros::message_traits::datatype(message),
               ros::message_traits::definition(message), "");
  ros::serialization::IStream in(bytes.data(), size);
  shape->read(in);
  return shape;
}

}  // namespace sfw
