#pragma once

#include "cli/options.h"

namespace sfw {

/// Each function runs one subcommand of `sfw`. It declares its options, parses them and does its
/// work.
/// @throw InputError or std::system_error if it cannot do its work
void runMap(Options& options);
void runMerge(Options& options);
void runAccessPoints(Options& options);
void runEvaluate(Options& options);
void runCloseLoops(Options& options);
void runLocalise(Options& options);
void runVisibility(Options& options);
void runDense(Options& options);
void runChooseSites(Options& options);
void runSimulate(Options& options);
void runNext(Options& options);
void runExplore(Options& options);
void runBench(Options& options);
void runFit(Options& options);
void runWallDrives(Options& options);

}  // namespace sfw
