#include "ros/conversion/field_path.h"

#include <algorithm>

namespace sfw {
namespace {

using Json = nlohmann::json;

const MessageField* fieldOf(const MessageFields& fields, const std::string& name) {
  const auto found = std::find_if(fields.fields.begin(), fields.fields.end(),
                                  [&](const MessageField& field) { return field.name == name; });
  return found == fields.fields.end() ? nullptr : &*found;
}

bool isArray(const MessageField& field) { return field.count != MessageField::Count::kOne; }

const Json* memberOf(const Json& object, const std::string& name) {
  if (!object.is_object()) {
    return nullptr;
  }
  const auto found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

}  // namespace

FieldPath::FieldPath(std::string_view text) {
  while (!text.empty()) {
    const std::size_t dot = std::min(text.find('.'), text.size());
    std::string_view name = text.substr(0, dot);
    const bool is_list = name.size() > 2 && name.substr(name.size() - 2) == "[]";
    name.remove_suffix(is_list ? 2 : 0);
    parts_.push_back({std::string(name), is_list});
    text.remove_prefix(std::min(dot + 1, text.size()));
  }
}

bool FieldPath::hasList() const {
  return std::any_of(parts_.begin(), parts_.end(), [](const Part& part) { return part.is_list; });
}

void FieldPath::addNames(std::set<std::string>& names) const {
  for (const Part& part : parts_) {
    names.insert(part.name);
  }
}

bool FieldPath::isIn(const MessageLayout& layout, const MessageFields& fields) const {
  const MessageFields* within = &fields;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const MessageField* field = within == nullptr ? nullptr : fieldOf(*within, parts_[i].name);
    const bool is_last = i + 1 == parts_.size();
    if (field == nullptr || (parts_[i].is_list && !isArray(*field)) ||
        (!is_last && isArray(*field) != parts_[i].is_list)) {
      return false;
    }
    within = field->type == FieldType::kMessage ? &layout.message(field->message) : nullptr;
  }
  return !parts_.empty();
}

const MessageFields* FieldPath::listIn(const MessageLayout& layout) const {
  const MessageFields* within = &layout.root();
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const MessageField* field = fieldOf(*within, parts_[i].name);
    const bool must_be_list = parts_[i].is_list || i + 1 == parts_.size();
    if (field == nullptr || isArray(*field) != must_be_list || field->type != FieldType::kMessage) {
      return nullptr;
    }
    within = &layout.message(field->message);
  }
  return within;
}

const Json* FieldPath::find(const Json& from, std::size_t index) const {
  const Json* value = &from;
  for (const Part& part : parts_) {
    value = memberOf(*value, part.name);
    if (value != nullptr && part.is_list) {
      value = value->is_array() && index < value->size() ? &(*value)[index] : nullptr;
    }
    if (value == nullptr) {
      return nullptr;
    }
  }
  return value;
}

std::size_t FieldPath::length(const Json& from) const {
  const Json* value = &from;
  for (const Part& part : parts_) {
    value = memberOf(*value, part.name);
    if (value == nullptr || part.is_list) {
      return value != nullptr && value->is_array() ? value->size() : 0;
    }
  }
  return 0;
}

std::vector<const Json*> FieldPath::elements(const Json& from) const {
  std::vector<const Json*> found = {&from};
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const bool is_list = parts_[i].is_list || i + 1 == parts_.size();
    std::vector<const Json*> next;
    for (const Json* object : found) {
      const Json* value = memberOf(*object, parts_[i].name);
      if (object->is_null()) {
        next.push_back(object);
      } else if (value != nullptr && !is_list) {
        next.push_back(value);
      } else if (value != nullptr && value->is_array()) {
        for (const Json& element : *value) {
          next.push_back(&element);
        }
      }
    }
    found = std::move(next);
  }
  return found;
}

}  // namespace sfw
