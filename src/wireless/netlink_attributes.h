#pragma once

#include <netlink/attr.h>
#include <netlink/genl/genl.h>
#include <netlink/msg.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string>

#include "wireless/nl80211_messages.h"

namespace sfw {

/// The attributes of a message or of an attribute, by their type.
template <std::size_t kLargest>
class Attributes {
 public:
  /// The attributes behind the header of generic netlink.
  static std::optional<Attributes> of(const Bytes& message, std::uint8_t command) {
    if (!parseHeader(message)) {
      return std::nullopt;
    }
    auto* header = headerOf(message);
    if (genlmsg_valid_hdr(header, 0) == 0) {
      return std::nullopt;
    }
    const auto* generic = static_cast<const genlmsghdr*>(nlmsg_data(header));
    if (generic->cmd != command) {
      return std::nullopt;
    }
    Attributes result;
    result.parse(genlmsg_attrdata(generic, 0), genlmsg_attrlen(generic, 0));
    return result;
  }

  /// The attributes inside of an attribute.
  static Attributes inside(const nlattr* attribute) {
    Attributes result;
    if (attribute != nullptr) {
      result.parse(static_cast<const nlattr*>(nla_data(attribute)), nla_len(attribute));
    }
    return result;
  }

  const nlattr* at(int type) const { return found_.at(static_cast<std::size_t>(type)); }

  template <class Number>
  std::optional<Number> number(int type) const {
    const nlattr* attribute = at(type);
    if (attribute == nullptr || nla_len(attribute) < static_cast<int>(sizeof(Number))) {
      return std::nullopt;
    }
    Number value;
    std::memcpy(&value, nla_data(attribute), sizeof value);
    return value;
  }

  std::optional<Bssid> address(int type) const {
    constexpr int kLength = 6;
    const nlattr* attribute = at(type);
    if (attribute == nullptr || nla_len(attribute) < kLength) {
      return std::nullopt;
    }
    const auto* byte = static_cast<const std::uint8_t*>(nla_data(attribute));
    char text[18];
    std::snprintf(text, sizeof text, "%02x:%02x:%02x:%02x:%02x:%02x", byte[0], byte[1], byte[2],
                  byte[3], byte[4], byte[5]);
    return Bssid::parse(text);
  }

  std::string text(int type) const {
    const nlattr* attribute = at(type);
    if (attribute == nullptr) {
      return {};
    }
    const auto* begin = static_cast<const char*>(nla_data(attribute));
    return std::string(begin, strnlen(begin, static_cast<std::size_t>(nla_len(attribute))));
  }

 private:
  static nlmsghdr* headerOf(const Bytes& message) {
    // libnl's accessors take no constant header, and do not write to it.
    return reinterpret_cast<nlmsghdr*>(const_cast<std::uint8_t*>(message.data()));
  }

  void parse(const nlattr* first, int length) {
    int left = length;
    for (const nlattr* one = first; nla_ok(one, left) != 0; one = nla_next(one, &left)) {
      const auto type = static_cast<std::size_t>(nla_type(one));
      if (type <= kLargest) {
        found_[type] = one;
      }
    }
  }

  std::array<const nlattr*, kLargest + 1> found_{};
};

/// Calls `visit` with each attribute inside of an attribute.
template <class Visitor>
void forEachInside(const nlattr* attribute, Visitor&& visit) {
  if (attribute == nullptr) {
    return;
  }
  int left = nla_len(attribute);
  for (const auto* one = static_cast<const nlattr*>(nla_data(attribute)); nla_ok(one, left) != 0;
       one = nla_next(one, &left)) {
    visit(one);
  }
}

}  // namespace sfw
