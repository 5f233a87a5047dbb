// Floor plans of HouseExpo: JSON.

#include "fuzz_target.h"
#include "simulation/building/floor_plan_io.h"

namespace sfw::fuzz {

std::vector<std::string> seeds() {
  return {
      R"({"verts": [[0, 0], [4, 0], [4, 3], [0, 3]], "id": "a", "room_num": 1})",
      R"({"verts": [[0, 0], [2, 0], [2, 1.5], [2.05, 1.5], [2.05, 0], [4, 0], [4, 3], [0, 3]]})",
      R"({"bbox": {"min": [0, 0], "max": [1, 1]}, "verts": [[0, 0], [1e0, 0], [1, 1]]})",
  };
}

void feed(std::string_view input) {
  static const InputFolder folder;
  const std::string file = folder.write("plan.json", input);
  takes([&] {
    const FloorPlan plan = readFloorPlan(file, {0.25, 0.0});
    require(plan.cells.size() == plan.geometry.size());
  });
}

}  // namespace sfw::fuzz
