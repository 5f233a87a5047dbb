#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sfw {

/// The types of fields that messages of ROS 1 and their constants have.
enum class FieldType {
  kBool,
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat32,
  kFloat64,
  kString,
  kTime,
  kDuration,
  kMessage
};

/// A field of a message.
struct MessageField {
  enum class Count { kOne, kFixed, kAny };

  std::string name;
  FieldType type = FieldType::kBool;
  std::size_t message = 0;  ///< index of its layout, if it is a message
  Count count = Count::kOne;
  std::uint32_t fixed_count = 0;  ///< with kFixed
};

/// The fields of a message, except those that take no bytes.
struct MessageFields {
  std::vector<MessageField> fields;
  std::uint64_t least_bytes = 0;  ///< of its serialization; at most 2^40
};

/// The fields of a message type and of all types in it, as its definition tells them.
class MessageLayout {
 public:
  /// Reads a definition as bags and connections carry it: the text of the message file, and after
  /// each line of '=' one of the types in it, with the title "MSG: package/Type".
  /// @param type  package/Type of the message, whose package also has the types without package
  /// @throw InputError saying what cannot be read. Definitions of more than 256 KiB, with more than
  ///     64 types, or with a type that contains itself are refused.
  MessageLayout(const std::string& type, const std::string& definition);

  /// The fields of the message.
  const MessageFields& root() const { return messages_.front(); }

  /// The fields of a type in it, by MessageField::message.
  const MessageFields& message(std::size_t index) const { return messages_[index]; }

 private:
  std::vector<MessageFields> messages_;
};

/// The bytes of a value that is no message: 4, the length, for a string.
std::uint64_t leastBytes(FieldType type);

}  // namespace sfw
