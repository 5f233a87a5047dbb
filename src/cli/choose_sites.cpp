#include <iostream>
#include <string>

#include "cli/building_options.h"
#include "cli/commands.h"
#include "simulation/scenario.h"
#include "structure_from_wifi/access_points_io.h"

namespace sfw {

void runChooseSites(Options& options) {
  BuildingSource building;
  std::int64_t count = 2;
  std::int64_t seed = 1;
  bool parameter = false;
  addBuildingOptions(options, building);
  options.addInRange("count", count, 1, 100, "number of access points");
  options.add("seed", "N", seed, "seed of the random choice of sites");
  options.addFlag("parameter", parameter,
                  "leave out the key access_points, as for a ROS parameter of that name");
  if (!options.parse()) {
    return;
  }
  const std::string table =
      accessPointsYaml(placeAccessPoints(makeFloorPlan(building, seed), count, seed));
  // The key's line comes first, alone.
  std::cout << (parameter ? table.substr(table.find('\n') + 1) : table);
}

}  // namespace sfw
