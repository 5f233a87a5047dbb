#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "structure_from_wifi/bssid.h"

namespace sfw {

/// Examples that one note names.
constexpr std::size_t kMostNamed = 3;

/// "1 pose is" or "3 poses are".
inline std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

/// A number with so many decimals.
inline std::string rounded(double value, int decimals) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(decimals) << value;
  return text.str();
}

/// A whole number, or a small one with two significant digits, such as 49 or 0.00051.
inline std::string roughly(double value) {
  constexpr double kLarge = 10.0;
  std::ostringstream text;
  text << std::setprecision(2) << value;
  return std::abs(value) >= kLarge ? rounded(value, 0) : text.str();
}

inline std::string secondsText(std::int64_t stamp_ns) {
  return rounded(1e-9 * static_cast<double>(stamp_ns), 3) + " s";
}

/// "A, B, C, ...", with so many names at most.
inline std::string named(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < kMostNamed; ++i) {
    text += (i > 0 ? ", " : "") + names[i];
  }
  return text + (names.size() > kMostNamed ? ", ..." : "");
}

inline std::string named(const std::vector<Bssid>& radios) {
  std::vector<std::string> names;
  for (const Bssid& radio : radios) {
    names.push_back(radio.str());
  }
  return named(names);
}

}  // namespace sfw
