#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "ros/conversion/message_layout.h"

namespace sfw {

/// Names of fields from outside to inside, as "networks[].mac" in a ScanFormat.
class FieldPath {
 public:
  /// Reads names joined by dots; each may end with "[]".
  explicit FieldPath(std::string_view text);

  bool empty() const { return parts_.empty(); }

  /// Whether a part ends with "[]".
  bool hasList() const;

  /// Adds the names of its fields.
  void addNames(std::set<std::string>& names) const;

  /// Whether a message has the field.
  bool isIn(const MessageLayout& layout, const MessageFields& fields) const;

  /// The fields of the messages in the list at the path; nullptr without such a list.
  const MessageFields* listIn(const MessageLayout& layout) const;

  /// The value at the path, with element `index` of each list; nullptr if there is none.
  const nlohmann::json* find(const nlohmann::json& from, std::size_t index) const;

  /// The length of the first list on the path; 0 without one.
  std::size_t length(const nlohmann::json& from) const;

  /// The elements of the list at the path, and of the lists on the way to it. A null on the way is
  /// taken for one element.
  std::vector<const nlohmann::json*> elements(const nlohmann::json& from) const;

 private:
  struct Part {
    std::string name;
    bool is_list = false;
  };

  std::vector<Part> parts_;
};

}  // namespace sfw
