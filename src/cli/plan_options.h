#pragma once

#include <cstdint>
#include <string>

#include "cli/options.h"
#include "simulation/building/floor_plan_io.h"
#include "simulation/building/plan_generator.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// A floor plan as the command line names it.
struct PlanArgument {
  std::string file;
  double metres_per_pixel = 0.0;  ///< 0: not given
  PlanOptions options;

  /// @throw InputError as readFloorPlan
  FloorPlan read() const;
};

/// Adds --plan, --resolution and --metres-per-pixel to a subcommand.
void addPlanOptions(Options& options, PlanArgument& plan);

/// A building from a file or made up.
struct BuildingArgument {
  PlanArgument plan;
  std::string generate;  ///< "flat", "office", or empty: not given
  double area_m2 = PlanGeneratorConfig().area_m2;

  /// @param seed  of a building made up
  /// @throw InputError as readFloorPlan and generatePlan, or unless just one of the two is given
  FloorPlan make(std::int64_t seed) const;
};

/// Adds the options of addPlanOptions, --generate and --area to a subcommand.
void addBuildingOptions(Options& options, BuildingArgument& building);

/// Reads "X,Y" [m]. @throw InputError naming the option.
Position parsePosition(const std::string& option, const std::string& text);

}  // namespace sfw
