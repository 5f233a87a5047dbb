#pragma once

#include <CLI/CLI.hpp>

namespace sfw {

/// Each adds one subcommand to `sfw`. Its callback throws InputError or std::system_error when it
/// cannot do its work; main() turns that into a message and exit status 1.
void addMapCommand(CLI::App& sfw);
void addEvaluateCommand(CLI::App& sfw);
void addVisibilityCommand(CLI::App& sfw);
void addDenseCommand(CLI::App& sfw);
void addPlaceCommand(CLI::App& sfw);
void addSimulateCommand(CLI::App& sfw);
void addBenchCommand(CLI::App& sfw);
void addFitCommand(CLI::App& sfw);

}  // namespace sfw
