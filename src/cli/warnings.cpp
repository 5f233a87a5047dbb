#include "cli/warnings.h"

#include <iostream>

namespace sfw {

void warn(const std::string& text) { std::cerr << "sfw: warning: " << text << '\n'; }

ReadingFile readWithWarnings(const std::string& file) {
  ReadingFile input = readReadings(file);
  for (const auto& [reason, skipped] : input.skipped) {
    warn(file + ": " + std::to_string(skipped.count) + " rows skipped: " + reason +
         " (first: " + skipped.first + ")");
  }
  return input;
}

}  // namespace sfw
