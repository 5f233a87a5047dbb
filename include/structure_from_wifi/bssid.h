#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "structure_from_wifi/export.h"

namespace sfw {

/// The hardware address of an access point's radio: the key of readings and access points.
class SFW_EXPORT Bssid {
 public:
  /// Reads twelve hexadecimal digits in either case: alone, or as 01:23:45:67:89:ab,
  /// 01-23-45-67-89-ab, 0123.4567.89ab or 012345-6789ab.
  /// @return nothing if the text is malformed or all zero (a radio that is not associated).
  static std::optional<Bssid> parse(std::string_view text);

  /// The canonical form, lower case with colons.
  std::string str() const;

  /// Whether two addresses often belong to one radio: their last octets differ by less than 16, and
  /// the others are equal, but for the first one, which shows variants of local administration.
  bool isRelatedTo(Bssid other) const;

  /// Compares addresses.
  /// @{
  friend bool operator==(Bssid a, Bssid b) { return a.value_ == b.value_; }
  friend bool operator!=(Bssid a, Bssid b) { return a.value_ != b.value_; }
  friend bool operator<(Bssid a, Bssid b) { return a.value_ < b.value_; }
  /// @}

 private:
  std::uint64_t value_ = 0;
};

}  // namespace sfw
