#include <iostream>
#include <memory>
#include <string>

#include "cli/commands.h"
#include "cli/plan_options.h"
#include "simulation/scenario.h"
#include "structure_from_wifi/map_files.h"

namespace sfw {
namespace {

struct PlaceOptions {
  BuildingArgument building;
  std::int64_t count = 2;
  std::int64_t seed = 1;
  bool parameter = false;
};

void run(const PlaceOptions& options) {
  const std::string table = accessPointsYaml(
      placeAccessPoints(options.building.make(options.seed), options.count, options.seed));
  // The key's line comes first, alone.
  std::cout << (options.parameter ? table.substr(table.find('\n') + 1) : table);
}

}  // namespace

void addPlaceCommand(CLI::App& sfw) {
  const auto options = std::make_shared<PlaceOptions>();
  CLI::App* command = sfw.add_subcommand(
      "place", "Choose places for access points in a known building and print their table.");
  addBuildingOptions(*command, options->building);
  command->add_option("--count", options->count, "how many")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "another one, other places")->capture_default_str();
  command->add_flag("--parameter", options->parameter,
                    "leave out the key access_points, as for a ROS parameter of that name");
  command->callback([options] { run(*options); });
}

}  // namespace sfw
