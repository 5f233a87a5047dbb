#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "base/median.h"

namespace sfw {

/// CPU time of one call [s], by all threads. The call returns a number that depends on all of its
/// work.
inline double cpuSeconds(const std::function<double()>& work) {
  const std::clock_t start = std::clock();
  double result = work();
  benchmark::DoNotOptimize(result);
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

inline double leastOf(const std::vector<double>& values) {
  return *std::min_element(values.begin(), values.end());
}

/// CPU times of two pieces of work that run by turns.
struct Turns {
  std::vector<double> own_s;
  std::vector<double> reference_s;
};

/// Runs both by turns. The time of the benchmark is that of our own work alone.
inline Turns takeTurns(benchmark::State& state, const std::function<double()>& own,
                       const std::function<double()>& reference) {
  Turns turns;
  while (state.KeepRunning()) {
    turns.own_s.push_back(cpuSeconds(own));
    state.PauseTiming();
    turns.reference_s.push_back(cpuSeconds(reference));
    state.ResumeTiming();
  }
  return turns;
}

/// Our own work, a reference, and the number of items that each works on.
struct Pair {
  std::size_t items;
  std::function<double()> own;
  std::function<double()> reference;
};

/// Declares the comparison of a pair, 15 turns each. Counters: the least times, and the reference's
/// time over ours as ratio of these, median of the turns and least.
/// @param prepare  makes the pair; called once, when the benchmark runs
inline void declareComparison(const std::string& name, const std::function<Pair()>& prepare) {
  constexpr int kTurns = 15;
  benchmark::RegisterBenchmark(name.c_str(),
                               [prepare](benchmark::State& state) {
                                 const Pair pair = prepare();
                                 const Turns turns = takeTurns(state, pair.own, pair.reference);
                                 std::vector<double> ratios;
                                 for (std::size_t i = 0; i < turns.own_s.size(); ++i) {
                                   ratios.push_back(turns.reference_s[i] / turns.own_s[i]);
                                 }
                                 state.counters["items"] = static_cast<double>(pair.items);
                                 state.counters["own_ms"] = 1e3 * leastOf(turns.own_s);
                                 state.counters["reference_ms"] = 1e3 * leastOf(turns.reference_s);
                                 state.counters["ratio"] =
                                     leastOf(turns.reference_s) / leastOf(turns.own_s);
                                 state.counters["ratio_median"] = median(ratios);
                                 state.counters["ratio_least"] = leastOf(ratios);
                               })
      ->Iterations(kTurns)
      ->Unit(benchmark::kMillisecond);
}

/// The main function of a benchmark.
/// @param declare  registers the benchmarks; gets the arguments that are not Google Benchmark's
inline int runBenchmarks(int count, char** arguments,
                         const std::function<void(const std::vector<std::string>&)>& declare) {
  try {
    benchmark::Initialize(&count, arguments);
    declare({arguments + 1, arguments + count});
    benchmark::RunSpecifiedBenchmarks();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", arguments[0], error.what());
    return 1;
  }
  return 0;
}

}  // namespace sfw
