#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "structure_from_wifi/plan_io.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// A floor plan as the command line names it.
struct PlanArgument {
  std::string file;
  double metres_per_pixel = 0.0;  ///< 0: not given
  PlanOptions options;

  /// @throw InputError as readPlan
  Plan read() const;
};

/// Adds --plan, --resolution and --metres-per-pixel to a subcommand.
void addPlanOptions(CLI::App& command, PlanArgument& plan);

/// Reads "X,Y" [m]. @throw InputError naming the option.
Position parsePosition(const std::string& option, const std::string& text);

}  // namespace sfw
