#include "cli/progress.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <string>

namespace sfw {
namespace {

constexpr std::size_t kTenths = 10;

/// "1:02:03" or "2:03"
std::string clockText(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(seconds));
  char text[32];
  if (whole >= 3600) {
    std::snprintf(text, sizeof text, "%lld:%02lld:%02lld", whole / 3600, whole / 60 % 60,
                  whole % 60);
  } else {
    std::snprintf(text, sizeof text, "%lld:%02lld", whole / 60, whole % 60);
  }
  return text;
}

}  // namespace

Progress::Progress(std::size_t all)
    : all_(all), shown_(isatty(STDERR_FILENO) != 0), start_(std::chrono::steady_clock::now()) {}

void Progress::add(bool at_once) {
  ++done_;
  at_once_ += at_once ? 1 : 0;
  if (shown_) {
    show();
  } else if (kTenths * done_ / all_ > kTenths * (done_ - 1) / all_) {
    std::cerr << "sfw: " + std::to_string(done_) + " of " + std::to_string(all_) + " done\n"
              << std::flush;
  }
}

void Progress::show() const {
  constexpr std::size_t kWidth = 40;
  const std::size_t filled = kWidth * done_ / all_;
  const double passed =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  std::string left;
  if (done_ == all_) {
    left = ", done in " + clockText(passed);
  } else if (done_ > at_once_) {
    left = ", " +
           clockText(passed / static_cast<double>(done_ - at_once_) *
                     static_cast<double>(all_ - done_)) +
           " left";
  }
  // The blanks cover the rest of a longer line.
  std::cerr << "\r[" << std::string(filled, '=') << std::string(kWidth - filled, ' ') << "] "
            << done_ << '/' << all_ << left << "        " << (done_ == all_ ? "\n" : "")
            << std::flush;
}

}  // namespace sfw
