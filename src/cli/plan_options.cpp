#include "cli/plan_options.h"

#include <sstream>

#include "structure_from_wifi/input_error.h"

namespace sfw {

FloorPlan PlanArgument::read() const {
  PlanOptions complete = options;
  if (metres_per_pixel != 0.0) {
    complete.metres_per_pixel = metres_per_pixel;
  }
  return readFloorPlan(file, complete);
}

void addPlanOptions(CLI::App& command, PlanArgument& plan) {
  command.add_option("--plan", plan.file, "floor plan: map_server YAML, HouseExpo JSON, or PNG");
  command
      .add_option("--resolution", plan.options.resolution,
                  "edge of a cell of a plan drawn in metres (HouseExpo) [m]")
      ->capture_default_str();
  command.add_option("--metres-per-pixel", plan.metres_per_pixel, "scale of a PNG");
}

FloorPlan BuildingArgument::make(std::int64_t seed) const {
  if (plan.file.empty() == generate.empty()) {
    throw InputError("needs either --plan or --generate");
  }
  if (generate.empty()) {
    return plan.read();
  }
  PlanGeneratorConfig config;
  config.kind = parseBuildingKind(generate);
  config.area = area;
  config.resolution = plan.options.resolution;
  config.seed = static_cast<std::uint64_t>(seed);
  return generatePlan(config).plan;
}

void addBuildingOptions(CLI::App& command, BuildingArgument& building) {
  addPlanOptions(command, building.plan);
  command.add_option("--generate", building.generate, "make a building up: flat or office");
  command.add_option("--area", building.area, "of a building made up [m2], 30..400")
      ->capture_default_str();
}

Position parsePosition(const std::string& option, const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  Position position;
  char comma = '\0';
  stream >> position.x() >> comma >> position.y();
  if (!stream || comma != ',' || !position.allFinite() || stream.peek() != EOF) {
    throw InputError(option + " must be X,Y in metres, as in 2.5,1.0; it is '" + text + "'");
  }
  return position;
}

}  // namespace sfw
