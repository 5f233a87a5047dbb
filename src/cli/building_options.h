#pragma once

#include <string>

#include "cli/options.h"
#include "simulation/building/building_source.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Adds --plan, --resolution and --metres-per-pixel to a subcommand.
void addFloorPlanOptions(Options& options, BuildingSource& source);

/// Adds the options of addFloorPlanOptions, --generate and --area to a subcommand.
void addBuildingOptions(Options& options, BuildingSource& source);

/// Reads "X,Y" [m]. @throw InputError naming the option.
Position parsePosition(const std::string& option, const std::string& text);

}  // namespace sfw
