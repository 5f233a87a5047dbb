#include <algorithm>
#include <iostream>
#include <memory>

#include "cli/building_options.h"
#include "cli/commands.h"
#include "files/atomic_file.h"
#include "files/map_server.h"
#include "k_visibility/k_visibility.h"
#include "output/k_map_io.h"
#include "output/map_picture.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

struct VisibilityOptions {
  BuildingSource building;
  std::string access_point;
  std::int64_t max_k = kMostWalls;
  std::string output;
};

void run(const VisibilityOptions& options) {
  const Position access_point = parsePosition("--access-point", options.access_point);
  const Grid<CellState> plan =
      toStates(readFloorPlan(options.building.plan, options.building.options));
  if (!plan.geometry.contains(plan.geometry.cellAt(access_point))) {
    throw InputError("--access-point " + options.access_point + " lies outside " +
                     options.building.plan);
  }
  KMap k_map{forwardKVisibility(plan, access_point), access_point};
  for (std::uint8_t& count : k_map.counts.cells) {
    count = count <= kMostWalls && count > options.max_k ? kNoCount : count;
  }
  writeKMap(k_map, options.output);
  std::cerr << "sfw: wrote k.pgm, k.yaml and k.png to " << options.output << '\n';
}

struct DenseOptions {
  std::string k_map;
  std::string output;
};

void run(const DenseOptions& options) {
  const KMap k_map = readKMap(options.k_map);
  const Grid<CellState> walls = denseInverseKVisibility(k_map.counts, k_map.access_point);
  const std::string picture = renderPicture(walls, k_map.access_point);
  writeMap(walls, options.output, "map");
  writeAtomically(options.output + "/map.png", picture);
  std::cerr << "sfw: wrote map.pgm, map.yaml and map.png to " << options.output << '\n';
}

}  // namespace

void runVisibility(Options& options) {
  VisibilityOptions visibility;
  addFloorPlanOptions(options, visibility.building);
  options.require("plan");
  options.addRequired("access-point", "X,Y", visibility.access_point,
                      "position of the access point in the frame of the plan [m]");
  options.addInRange("max-k", visibility.max_k, 0, kMostWalls,
                     "cells behind more walls get no count");
  options.addRequired("output", "DIRECTORY", visibility.output,
                      "directory for k.pgm, k.yaml and k.png");
  if (options.parse()) {
    run(visibility);
  }
}

void runDense(Options& options) {
  DenseOptions dense;
  options.addRequired("k-map", "FILE", dense.k_map, "k.pgm or k.yaml as `sfw visibility` writes");
  options.addRequired("output", "DIRECTORY", dense.output,
                      "directory for map.pgm, map.yaml and map.png");
  if (options.parse()) {
    run(dense);
  }
}

}  // namespace sfw
