#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <functional>
#include <vector>

#include "base/median.h"

namespace sfw {

inline volatile double consumed = 0.0;  // keeps the compiler from removing the work

/// CPU time of one call [s].
inline double cpuSeconds(const std::function<double()>& work) {
  const std::clock_t start = std::clock();
  consumed = consumed + work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// The least CPU time of several calls [s]: other processes disturbed the others.
inline double leastCpuSeconds(int repetitions, const std::function<double()>& work) {
  double least = cpuSeconds(work);
  for (int i = 1; i < repetitions; ++i) {
    least = std::min(least, cpuSeconds(work));
  }
  return least;
}

/// Runs both in turns and prints a row: the least time of each, and the library's time over ours as
/// ratio of the least times, median and least ratio.
/// @param own,library  return a number that depends on all of their work
inline void compare(const char* part, std::size_t size, const std::function<double()>& own,
                    const std::function<double()>& library) {
  std::vector<double> own_s, library_s, ratios;
  constexpr int kRepetitions = 15;
  for (int i = 0; i < kRepetitions; ++i) {
    own_s.push_back(cpuSeconds(own));
    library_s.push_back(cpuSeconds(library));
    ratios.push_back(library_s.back() / own_s.back());
  }
  const double own_best_s = *std::min_element(own_s.begin(), own_s.end());
  const double library_best_s = *std::min_element(library_s.begin(), library_s.end());
  std::printf("| %s | %zu | %.2f | %.2f | %.2f | %.2f | %.2f |\n", part, size, 1e3 * own_best_s,
              1e3 * library_best_s, library_best_s / own_best_s, median(ratios),
              *std::min_element(ratios.begin(), ratios.end()));
  std::fflush(stdout);
}

}  // namespace sfw
