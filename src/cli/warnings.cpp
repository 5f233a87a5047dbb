#include "warnings.h"

#include <unistd.h>

#include <iostream>

namespace sfw {

void warn(const std::string& text) { std::cerr << "sfw: warning: " << text << '\n'; }

void showProgress(std::size_t done, std::size_t all) {
  if (isatty(STDERR_FILENO) == 0) {
    return;
  }
  constexpr std::size_t kWidth = 40;
  const std::size_t filled = kWidth * done / all;
  std::cerr << "\r[" << std::string(filled, '=') << std::string(kWidth - filled, ' ') << "] "
            << done << '/' << all << (done == all ? "\n" : "") << std::flush;
}

std::vector<Reading> readWithWarnings(const std::string& file) {
  ReadingFile input = readReadings(file);
  for (const auto& [reason, skipped] : input.skipped) {
    warn(file + ": " + std::to_string(skipped.count) + " rows skipped: " + reason +
         " (first: " + skipped.first + ")");
  }
  return std::move(input.readings);
}

}  // namespace sfw
