// Maps and floor plans of map_server: YAML, and a PGM or a PNG beside it.

#include <cmath>

#include "files/map_server.h"
#include "files/png.h"
#include "fuzz_target.h"
#include "output/k_map_io.h"
#include "simulation/building/floor_plan_io.h"

namespace sfw::fuzz {
namespace {

const char kYaml[] =
    "image: map.pgm\nresolution: 0.05\norigin: [-1, 2.5, 0]\nnegate: 0\nmode: scale\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\ndecibels_per_step: 0.05\naccess_point: [0, 3]\n"
    "=====\n";

std::string picture() {
  TranslucentImage image{{4, 3, {}}, {}};
  for (int i = 0; i < 12; ++i) {
    image.grey.pixels.push_back(static_cast<std::uint8_t>(20 * i));
    image.opacity.push_back(i == 5 ? 0 : 255);
  }
  return encodePng(image);
}

}  // namespace

std::vector<std::string> seeds() {
  std::string with_picture = kYaml;
  with_picture.replace(with_picture.find(".pgm"), 4, ".png");
  return {
      std::string(kYaml) + "P5\n# a map\n4 3\n255\n" +
          std::string("\0\376\315\0\376\376\0\0\315\0\376\0", 12),
      std::string(kYaml) + "P2\n3 2\n15\n0 15 7\n1 2 3\n",
      with_picture + picture(),
      std::string(kYaml) +
          std::string("GIF89a\1\0\1\0\x80\0\0\0\0\0\xff\xff\xff!\xf9\4\1\0\0\0\0,\0"
                      "\0\0\0\1\0\1\0\0\2\1\104\0;",
                      42),
  };
}

void feed(std::string_view input) {
  static const InputFolder folder;
  const std::vector<std::string> files = parts(input, 2);
  const std::string yaml = folder.write("map.yaml", files[0]);
  const std::string pgm = folder.write("map.pgm", files[1]);
  const std::string png = folder.write("map.png", files[1]);
  takes([&] {
    const Grid<CellState> map = readMap(yaml);
    require(map.cells.size() == map.geometry.size());
  });
  takes([&] {
    for (const float probability : readProbabilities(yaml).cells) {
      require(probability >= 0.0F && probability <= 1.0F);
    }
  });
  takes([&] { readWallLoss(yaml); });
  takes([&] { readFloorPlan(yaml); });
  takes([&] { readFloorPlan(png, {0.05, 0.1}); });
  takes([&] { readKMap(pgm); });
}

}  // namespace sfw::fuzz
