#include "cli/building_options.h"

#include <sstream>

#include "structure_from_wifi/input_error.h"

namespace sfw {

void addFloorPlanOptions(Options& options, BuildingSource& source) {
  options.add("plan", "FILE", source.plan, "floor plan: map_server YAML, HouseExpo JSON, or PNG");
  options.add("resolution", "METRES", source.options.resolution_m,
              "edge of a cell of a HouseExpo plan or a generated building [m]");
  options.add("metres-per-pixel", "METRES", source.options.metres_per_pixel,
              "scale of a PNG [m]; 0 leaves it out");
}

void addBuildingOptions(Options& options, BuildingSource& source) {
  addFloorPlanOptions(options, source);
  options.add("generate", "KIND", source.generate, "generate a building: flat or office");
  options.add("area", "M2", source.area_m2, "area of a generated building [m2], in 30..400");
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
