#pragma once

#include <string>
#include <string_view>

#include "structure_from_wifi/export.h"

namespace sfw {

/// The name of a robot, in the size of a pointer: each of a million readings holds one.
///
/// All equal names share one text, which is kept until the program ends. So copies and comparisons
/// for equality cost as much as those of a pointer. Names convert from and to texts; the empty name
/// is that of the only robot. Thread-safe, as a text is: threads may make names at the same time.
class SFW_EXPORT RobotName {
 public:
  /// The empty name.
  RobotName() = default;

  /// The name with such a text. O(log names) and a mutex, unless it is empty.
  /// @{
  RobotName(std::string_view text);                                          // NOLINT(*-explicit-*)
  RobotName(const std::string& text) : RobotName(std::string_view(text)) {}  // NOLINT(*-explicit-*)
  RobotName(const char* text) : RobotName(std::string_view(text)) {}         // NOLINT(*-explicit-*)
  /// @}

  /// The text, valid until the program ends.
  /// @{
  const std::string& str() const { return text_ == nullptr ? emptyText() : *text_; }
  operator const std::string&() const { return str(); }  // NOLINT(*-explicit-*)
  /// @}

  bool empty() const { return text_ == nullptr; }

  /// Compares names; the order is that of their texts.
  /// @{
  friend bool operator==(RobotName a, RobotName b) { return a.text_ == b.text_; }
  friend bool operator!=(RobotName a, RobotName b) { return a.text_ != b.text_; }
  friend bool operator<(RobotName a, RobotName b) {
    return a.text_ != b.text_ && a.str() < b.str();
  }
  /// @}

 private:
  static const std::string& emptyText();

  const std::string* text_ = nullptr;  // in the table of names; nullptr: empty
};

}  // namespace sfw
