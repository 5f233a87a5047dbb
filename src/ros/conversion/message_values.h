#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "ros/conversion/message_layout.h"

namespace sfw {

/// Reads the values of a message into a tree of objects, arrays, numbers and texts. A time or a
/// duration becomes an object of `secs` and `nsecs`. After the first 20000 messages in arrays come
/// nulls.
///
/// It never reads outside of the bytes, and takes time and memory in proportion to them, whatever
/// the lengths in them say.
///
/// @param wanted  names of fields, at any depth; the others are left out
/// @throw InputError if the bytes are too few or too many for the layout
nlohmann::json readValues(const MessageLayout& layout, const std::vector<std::uint8_t>& bytes,
                          const std::set<std::string>& wanted);

}  // namespace sfw
