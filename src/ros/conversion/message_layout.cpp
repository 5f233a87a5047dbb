#include "ros/conversion/message_layout.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

constexpr std::size_t kLongestDefinition = 256 * 1024;
constexpr std::size_t kMostTypes = 64;
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 40;  // no sum of two of them overflows

struct TypeName {
  const char* name;
  FieldType type;
  std::uint64_t bytes;
};

constexpr TypeName kTypes[] = {
    {"bool", FieldType::kBool, 1},       {"int8", FieldType::kInt8, 1},
    {"uint8", FieldType::kUint8, 1},     {"int16", FieldType::kInt16, 2},
    {"uint16", FieldType::kUint16, 2},   {"int32", FieldType::kInt32, 4},
    {"uint32", FieldType::kUint32, 4},   {"int64", FieldType::kInt64, 8},
    {"uint64", FieldType::kUint64, 8},   {"float32", FieldType::kFloat32, 4},
    {"float64", FieldType::kFloat64, 8}, {"string", FieldType::kString, 4},
    {"time", FieldType::kTime, 8},       {"duration", FieldType::kDuration, 8},
    {"byte", FieldType::kInt8, 1},       {"char", FieldType::kUint8, 1},
};

/// A field whose type is still a name.
struct NamedField {
  MessageField field;
  std::string type;
};

using Lines = std::vector<std::string>;

std::string trimmed(const std::string& text) {
  constexpr char kSpace[] = " \t\r";
  const std::size_t first = text.find_first_not_of(kSpace);
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

bool isSeparator(const std::string& line) {
  return line.size() >= 3 && line.find_first_not_of('=') == std::string::npos;
}

/// The lines of each type. The first one has the key "".
std::map<std::string, Lines> sections(const std::string& definition) {
  std::map<std::string, Lines> sections;
  Lines* section = &sections[""];
  std::istringstream text(definition);
  bool is_title = false;
  for (std::string line; std::getline(text, line);) {
    line = trimmed(line);
    if (isSeparator(line)) {
      is_title = true;
    } else if (is_title && line.rfind("MSG:", 0) == 0) {
      section = &sections[trimmed(line.substr(4))];
      is_title = false;
    } else {
      section->push_back(line);
    }
    if (sections.size() > kMostTypes) {
      throw InputError("its definition has more than 64 types");
    }
  }
  return sections;
}

std::uint32_t countOf(const std::string& digits) {
  std::uint32_t count = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
  if (error != std::errc() || end != digits.data() + digits.size()) {
    throw InputError("its definition has an array of '" + digits.substr(0, 20) + "' values");
  }
  return count;
}

/// Reads "type name", "type[] name" or "type[3] name"; nothing for a constant or an empty line.
std::optional<NamedField> fieldOf(const std::string& line) {
  // A constant of type string may contain '#', but every constant has a '=' before that.
  const std::string code = trimmed(line.substr(0, line.find('#')));
  if (code.empty() || code.find('=') != std::string::npos) {
    return std::nullopt;
  }
  const std::size_t space = code.find_first_of(" \t");
  const std::string name = space == std::string::npos ? "" : trimmed(code.substr(space));
  if (name.empty() || name.find_first_of(" \t") != std::string::npos) {
    throw InputError("its definition has the line '" + code.substr(0, 80) + "', which is no field");
  }
  NamedField named;
  named.field.name = name;
  named.type = code.substr(0, space);
  const std::size_t bracket = named.type.find('[');
  if (bracket != std::string::npos) {
    if (named.type.back() != ']') {
      throw InputError("its definition has the type '" + named.type.substr(0, 80) + "'");
    }
    const std::string digits = named.type.substr(bracket + 1, named.type.size() - bracket - 2);
    using Count = MessageField::Count;
    named.field.count = digits.empty() ? Count::kAny : Count::kFixed;
    named.field.fixed_count = digits.empty() ? 0 : countOf(digits);
    named.type.resize(bracket);
  }
  return named;
}

/// Builds the layouts of a message and of the types in it.
class Builder {
 public:
  Builder(const std::string& type, const std::string& definition)
      : sections_(sections(definition)) {
    add(packageOf(type), sections_[""]);
  }

  std::vector<MessageFields> take() { return std::move(messages_); }

 private:
  static std::string packageOf(const std::string& type) { return type.substr(0, type.find('/')); }

  /// Adds the layout of a type.
  /// @return its index
  std::size_t add(const std::string& package, const Lines& lines) {
    const std::size_t index = messages_.size();
    messages_.emplace_back();
    MessageFields message;
    for (const std::string& line : lines) {
      if (std::optional<NamedField> named = fieldOf(line)) {
        resolve(package, *named);
        const std::uint64_t least_bytes = leastBytesOf(named->field);
        message.least_bytes = std::min(message.least_bytes + least_bytes, kMostBytes);
        if (least_bytes > 0) {  // so that the bytes bound the time of reading
          message.fields.push_back(std::move(named->field));
        }
      }
    }
    messages_[index] = std::move(message);
    return index;
  }

  void resolve(const std::string& package, NamedField& named) {
    const auto* known = std::find_if(std::begin(kTypes), std::end(kTypes),
                                     [&](const TypeName& type) { return type.name == named.type; });
    if (known != std::end(kTypes)) {
      named.field.type = known->type;
      return;
    }
    named.field.type = FieldType::kMessage;
    named.field.message = indexOf(fullName(package, named.type));
  }

  std::string fullName(const std::string& package, const std::string& type) const {
    if (type == "Header") {
      constexpr char kInOldBags[] = "roslib/Header";
      return sections_.count(kInOldBags) > 0 ? kInOldBags : "std_msgs/Header";
    }
    return type.find('/') == std::string::npos ? package + "/" + type : type;
  }

  std::size_t indexOf(const std::string& type) {
    const auto section = sections_.find(type);
    if (section == sections_.end() || type.empty()) {
      throw InputError("its definition lacks the type " + type.substr(0, 80));
    }
    if (!open_.emplace(type, true).second) {
      if (open_[type]) {
        throw InputError("its definition has a type that contains itself: " + type.substr(0, 80));
      }
      return indices_[type];
    }
    const std::size_t index = add(packageOf(type), section->second);
    open_[type] = false;
    indices_[type] = index;
    return index;
  }

  std::uint64_t leastBytesOf(const MessageField& field) const {
    if (field.count == MessageField::Count::kAny) {
      return 4;
    }
    const std::uint64_t one = field.type == FieldType::kMessage
                                  ? messages_[field.message].least_bytes
                                  : leastBytes(field.type);
    const std::uint64_t count = field.count == MessageField::Count::kFixed ? field.fixed_count : 1;
    return one > 0 && count > kMostBytes / one ? kMostBytes : one * count;
  }

  std::map<std::string, Lines> sections_;
  std::map<std::string, bool> open_;  // whether the type is being added, or has been
  std::map<std::string, std::size_t> indices_;
  std::vector<MessageFields> messages_;
};

}  // namespace

std::uint64_t leastBytes(FieldType type) {
  return std::find_if(std::begin(kTypes), std::end(kTypes),
                      [&](const TypeName& known) { return known.type == type; })
      ->bytes;
}

MessageLayout::MessageLayout(const std::string& type, const std::string& definition) {
  if (definition.size() > kLongestDefinition) {
    throw InputError("its definition is longer than 256 KiB");
  }
  messages_ = Builder(type, definition).take();
}

}  // namespace sfw
