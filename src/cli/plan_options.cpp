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

void addPlanOptions(Options& options, PlanArgument& plan) {
  options.add("plan", "FILE", plan.file, "floor plan: map_server YAML, HouseExpo JSON, or PNG");
  options.add("resolution", "METRES", plan.options.resolution_m,
              "edge of a cell of a plan drawn in metres (HouseExpo) [m]");
  options.add("metres-per-pixel", "METRES", plan.metres_per_pixel,
              "scale of a PNG [m]; 0 leaves it out");
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
  config.area_m2 = area_m2;
  config.resolution_m = plan.options.resolution_m;
  config.seed = static_cast<std::uint64_t>(seed);
  return generatePlan(config).plan;
}

void addBuildingOptions(Options& options, BuildingArgument& building) {
  addPlanOptions(options, building.plan);
  options.add("generate", "KIND", building.generate, "generate a building: flat or office");
  options.add("area", "M2", building.area_m2, "area of a generated building [m2], in 30..400");
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
