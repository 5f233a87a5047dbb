#include "ros/conversion/message_values.h"

#include <cstring>

#include "ros/conversion/scan_format.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

using Json = nlohmann::json;

// In all arrays together: twice kMostReadings, since readings may stand in lists of lists.
constexpr std::size_t kMostMessages = 2 * kMostReadings;

class ValueReader {
 public:
  ValueReader(const MessageLayout& layout, const std::vector<std::uint8_t>& bytes,
              const std::set<std::string>& wanted)
      : layout_(layout), wanted_(wanted), next_(bytes.data()), left_(bytes.size()) {}

  Json read() {
    Json root = readMessage(layout_.root(), true);
    if (left_ > 0) {
      throw InputError("a message has " + std::to_string(left_) + " bytes too many");
    }
    return root;
  }

 private:
  /// Reads a message, or passes over it.
  Json readMessage(const MessageFields& message, bool keeps) {
    Json object;
    if (keeps) {
      object = Json::object();
    }
    for (const MessageField& field : message.fields) {
      const bool is_wanted = keeps && wanted_.count(field.name) > 0;
      Json value = readField(field, is_wanted);
      if (is_wanted) {
        object[field.name] = std::move(value);
      }
    }
    return object;
  }

  Json readField(const MessageField& field, bool keeps) {
    if (field.count == MessageField::Count::kOne) {
      return readOne(field, keeps);
    }
    const std::uint64_t count =
        field.count == MessageField::Count::kFixed ? field.fixed_count : take<std::uint32_t>();
    const std::uint64_t least = field.type == FieldType::kMessage
                                    ? layout_.message(field.message).least_bytes
                                    : leastBytes(field.type);
    if (least > 0 && count > left_ / least) {
      throw InputError("a message ends within the array " + field.name.substr(0, 80));
    }
    if (!keeps && field.type != FieldType::kMessage && field.type != FieldType::kString) {
      pass(count * least);
      return nullptr;
    }
    Json array = Json::array();
    const bool is_message = field.type == FieldType::kMessage;
    for (std::uint64_t i = 0; least > 0 && i < count; ++i) {
      const bool is_kept = keeps && (!is_message || kept_messages_ < kMostMessages);
      kept_messages_ += is_kept && is_message ? 1 : 0;
      Json value = readOne(field, is_kept);
      if (keeps) {
        array.push_back(std::move(value));
      }
    }
    return array;
  }

  Json readOne(const MessageField& field, bool keeps) {
    switch (field.type) {
      case FieldType::kBool:
        return take<std::uint8_t>() != 0;
      case FieldType::kInt8:
        return take<std::int8_t>();
      case FieldType::kUint8:
        return take<std::uint8_t>();
      case FieldType::kInt16:
        return take<std::int16_t>();
      case FieldType::kUint16:
        return take<std::uint16_t>();
      case FieldType::kInt32:
        return take<std::int32_t>();
      case FieldType::kUint32:
        return take<std::uint32_t>();
      case FieldType::kInt64:
        return take<std::int64_t>();
      case FieldType::kUint64:
        return take<std::uint64_t>();
      case FieldType::kFloat32:
        return take<float>();
      case FieldType::kFloat64:
        return take<double>();
      case FieldType::kString:
        return readText(keeps);
      case FieldType::kTime:
        return readTime<std::uint32_t>(keeps);
      case FieldType::kDuration:
        return readTime<std::int32_t>(keeps);
      case FieldType::kMessage:
        break;
    }
    return readMessage(layout_.message(field.message), keeps);
  }

  Json readText(bool keeps) {
    const auto length = take<std::uint32_t>();
    const auto* text = reinterpret_cast<const char*>(pass(length));
    return keeps ? Json(std::string(text, length)) : Json();
  }

  template <class Part>
  Json readTime(bool keeps) {
    const auto secs = take<Part>();
    const auto nsecs = take<Part>();
    return keeps ? Json{{"secs", secs}, {"nsecs", nsecs}} : Json();
  }

  template <class Value>
  Value take() {
    Value value{};
    std::memcpy(&value, pass(sizeof value), sizeof value);  // little-endian, as ROS is
    return value;
  }

  const std::uint8_t* pass(std::uint64_t count) {
    if (count > left_) {
      throw InputError("a message has too few bytes");
    }
    const std::uint8_t* start = next_;
    next_ += count;
    left_ -= count;
    return start;
  }

  const MessageLayout& layout_;
  const std::set<std::string>& wanted_;
  const std::uint8_t* next_;
  std::uint64_t left_;
  std::size_t kept_messages_ = 0;
};

}  // namespace

nlohmann::json readValues(const MessageLayout& layout, const std::vector<std::uint8_t>& bytes,
                          const std::set<std::string>& wanted) {
  return ValueReader(layout, bytes, wanted).read();
}

}  // namespace sfw
