// YAML files of settings, of the mapper and of the node.

#include "fuzz_target.h"
#include "ros/conversion/ros_settings.h"
#include "structure_from_wifi/settings_io.h"

namespace sfw::fuzz {

std::vector<std::string> seeds() {
  return {
      "map: {resolution: 0.05, margin: 1, max_cells: 1000000}\nmethod: tomography\n",
      "belief:\n  free_threshold: 0.2\n  occupied_threshold: 0.65\nros:\n  publish_rate: 2\n"
      "  map_frame: floor\n",
      "tomography/bin: 0.3\nrssi: {window: 7, filter: mean}\naccess_points: []\n",
  };
}

void feed(std::string_view input) {
  static const InputFolder folder;
  const std::string file = folder.write("settings.yaml", input);
  takes([&] { require(validate(readConfig(file).config).empty()); });
  takes([&] {
    const MappingSettings settings = readMappingSettings(file);
    require(validate(settings.config).empty() && validate(settings.ros).empty());
  });
}

}  // namespace sfw::fuzz
