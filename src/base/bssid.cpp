#include "structure_from_wifi/bssid.h"

#include <cstdio>

namespace sfw {
namespace {

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

}  // namespace

std::optional<Bssid> Bssid::parse(std::string_view text) {
  constexpr std::size_t kLength = 17;
  if (text.size() != kLength) {
    return std::nullopt;
  }
  Bssid bssid;
  for (std::size_t i = 0; i < kLength; ++i) {
    if (i % 3 == 2) {
      if (text[i] != ':' && text[i] != '-') {
        return std::nullopt;
      }
      continue;
    }
    const int digit = hexDigit(text[i]);
    if (digit < 0) {
      return std::nullopt;
    }
    bssid.value_ = bssid.value_ << 4 | static_cast<std::uint64_t>(digit);
  }
  if (bssid.value_ == 0) {
    return std::nullopt;
  }
  return bssid;
}

std::string Bssid::str() const {
  char text[18];
  const auto byte = [this](int i) { return static_cast<unsigned>(value_ >> (8 * i) & 0xff); };
  std::snprintf(text, sizeof text, "%02x:%02x:%02x:%02x:%02x:%02x", byte(5), byte(4), byte(3),
                byte(2), byte(1), byte(0));
  return text;
}

}  // namespace sfw
