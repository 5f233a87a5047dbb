#include "structure_from_wifi/bssid.h"

#include <algorithm>
#include <cstdio>
#include <string>

namespace sfw {
namespace {

constexpr std::size_t kDigits = 12;

int hexDigit(char c) {
  if (c >= '0' && c <= '9') {
    return c - '0';
  }
  if (c >= 'a' && c <= 'f') {
    return c - 'a' + 10;
  }
  if (c >= 'A' && c <= 'F') {
    return c - 'A' + 10;
  }
  return -1;
}

/// Whether a text has only hexadecimal digits, and so many.
bool isHex(std::string_view text, std::size_t count) {
  return text.size() == count &&
         std::all_of(text.begin(), text.end(), [](char c) { return hexDigit(c) >= 0; });
}

/// The digits of groups of one size; empty if a group has another size.
std::string joinedGroups(std::string_view text, std::string_view separators, std::size_t size) {
  std::string digits;
  while (true) {
    const std::size_t end = std::min(text.find_first_of(separators), text.size());
    const std::string_view group = text.substr(0, end);
    if (!isHex(group, size)) {
      return "";
    }
    digits += group;
    if (end == text.size()) {
      return digits;
    }
    text.remove_prefix(end + 1);
  }
}

/// Reads 01:23:45:67:89:ab, the usual form; nothing for any other text.
std::optional<std::uint64_t> parseColons(std::string_view text) {
  constexpr std::size_t kLength = 17;
  if (text.size() != kLength) {
    return std::nullopt;
  }
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < kLength; ++i) {
    const bool is_colon = i % 3 == 2;
    const int digit = is_colon ? 0 : hexDigit(text[i]);
    if (digit < 0 || (is_colon && text[i] != ':')) {
      return std::nullopt;
    }
    value = is_colon ? value : value << 4 | static_cast<std::uint64_t>(digit);
  }
  return value;
}

/// The twelve digits of an address, or another number of characters.
std::string digitsOf(std::string_view text) {
  constexpr std::size_t kOctet = 2;
  if (isHex(text, kDigits)) {
    return std::string(text);
  }
  if (text.find('.') != std::string_view::npos) {
    return joinedGroups(text, ".", 2 * kOctet);
  }
  if (text.size() == kDigits + 1) {
    return joinedGroups(text, "-", 3 * kOctet);
  }
  return joinedGroups(text, ":-", kOctet);
}

}  // namespace

std::optional<Bssid> Bssid::parse(std::string_view text) {
  constexpr std::size_t kLongest = 17;
  Bssid bssid;
  if (const std::optional<std::uint64_t> usual = parseColons(text)) {
    bssid.value_ = *usual;
  } else {
    const std::string digits = text.size() <= kLongest ? digitsOf(text) : "";
    if (digits.size() != kDigits) {
      return std::nullopt;
    }
    for (const char digit : digits) {
      bssid.value_ = bssid.value_ << 4 | static_cast<std::uint64_t>(hexDigit(digit));
    }
  }
  return bssid.value_ == 0 ? std::nullopt : std::optional(bssid);
}

std::string Bssid::str() const {
  char text[18];
  const auto byte = [this](int i) { return static_cast<unsigned>(value_ >> (8 * i) & 0xff); };
  std::snprintf(text, sizeof text, "%02x:%02x:%02x:%02x:%02x:%02x", byte(5), byte(4), byte(3),
                byte(2), byte(1), byte(0));
  return text;
}

bool Bssid::isRelatedTo(Bssid other) const {
  constexpr std::uint64_t kMiddleOctets = 0x00ffffffff00;
  constexpr std::uint64_t kLastOctet = 0xff;
  constexpr std::uint64_t kApart = 16;
  const std::uint64_t a = value_ & kLastOctet;
  const std::uint64_t b = other.value_ & kLastOctet;
  return (value_ & kMiddleOctets) == (other.value_ & kMiddleOctets) &&
         std::max(a, b) - std::min(a, b) < kApart;
}

}  // namespace sfw
