// YAML tables of access points.

#include "fuzz_target.h"
#include "structure_from_wifi/access_points_io.h"

namespace sfw::fuzz {

std::vector<std::string> seeds() {
  return {
      "access_points:\n  - {bssid: \"02:00:00:00:00:01\", x: 1.5, y: -2, z: 2.2, name: hall, "
      "tx_dbm: 20}\n"
      "  - bssid: 02:00:00:00:00:02\n",
      "access_points: [{bssid: 02-00-00-00-00-0A, x: 0, y: 0, position_sd: 1.5}]\n",
      "a: &b [1, 2]\naccess_points: *b\n",
  };
}

void feed(std::string_view input) {
  static const InputFolder folder;
  const std::string file = folder.write("access_points.yaml", input);
  takes([&] {
    const AccessPointReading reading = readAccessPoints(file);
    require(!reading.access_points.empty());
    const std::string text = accessPointsYaml(reading.access_points);
    const AccessPointReading again = readAccessPoints(folder.write("again.yaml", text));
    require(again.warnings.empty() && accessPointsYaml(again.access_points) == text);
  });
}

}  // namespace sfw::fuzz
