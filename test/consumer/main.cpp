// Maps a drive along a wall and writes the map's files into the folder given.

#include <octomap/OcTree.h>

#include <iostream>

#include "structure_from_wifi/map_files.h"
#include "structure_from_wifi/mapper.h"
#include "structure_from_wifi/octomap_export.h"
#include "structure_from_wifi/version.h"

int main(int, char** argv) {
  sfw::AccessPoint router;
  router.bssid = *sfw::Bssid::parse("02:00:00:00:00:01");
  router.position = {2.0, -1.0};

  const sfw::Config config;
  sfw::Mapper mapper(config, {router});
  for (int second = 0; second < 40; ++second) {
    const sfw::Position antenna_in_map(0.1 * second, 1.0);
    mapper.insert({second * 1000000000LL, antenna_in_map, router.bssid, -50.0 - second % 7});
  }

  const auto snapshot = mapper.infer();
  sfw::writeMapFiles(*snapshot, config, argv[1]);
  const auto tree = sfw::toOctomap(snapshot->belief, config.octomap);
  std::cout << sfw::version() << ": " << tree->size() << " nodes\n";
  return tree->size() > 1 ? 0 : 1;
}
