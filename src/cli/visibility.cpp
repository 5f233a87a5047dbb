#include <algorithm>
#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/plan_options.h"
#include "files/atomic_file.h"
#include "k_visibility/k_visibility.h"
#include "output/k_map_io.h"
#include "output/map_picture.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/map_files.h"

namespace sfw {
namespace {

struct VisibilityOptions {
  PlanArgument plan;
  std::string access_point;
  int max_k = kMostWalls;
  std::string output;
};

void runVisibility(const VisibilityOptions& options) {
  const Position access_point = parsePosition("--access-point", options.access_point);
  const Grid<CellState> plan = toStates(options.plan.read());
  if (!plan.geometry.contains(plan.geometry.cellAt(access_point))) {
    throw InputError("--access-point " + options.access_point + " lies outside " +
                     options.plan.file);
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

void runDense(const DenseOptions& options) {
  const KMap k_map = readKMap(options.k_map);
  const Grid<CellState> walls = denseInverseKVisibility(k_map.counts, k_map.access_point);
  const std::string picture = renderPicture(walls, k_map.access_point);
  writePlanFiles(walls, options.output, "map");
  writeAtomically(options.output + "/map.png", picture);
  std::cerr << "sfw: wrote map.pgm, map.yaml and map.png to " << options.output << '\n';
}

}  // namespace

void addVisibilityCommand(CLI::App& sfw) {
  const auto options = std::make_shared<VisibilityOptions>();
  CLI::App* command =
      sfw.add_subcommand("visibility", "Count the walls between an access point and every cell.");
  addPlanOptions(*command, options->plan);
  command->get_option("--plan")->required();
  command->add_option("--access-point", options->access_point, "X,Y in the plan's frame [m]")
      ->required();
  command->add_option("--max-k", options->max_k, "higher counts are left out")
      ->check(CLI::Range(0, static_cast<int>(kMostWalls)))
      ->capture_default_str();
  command->add_option("--output", options->output, "directory for k.pgm, k.yaml and k.png")
      ->required();
  command->callback([options] { runVisibility(*options); });
}

void addDenseCommand(CLI::App& sfw) {
  const auto options = std::make_shared<DenseOptions>();
  CLI::App* command =
      sfw.add_subcommand("dense", "Find the walls from a full k map: dense inverse k-visibility.");
  command->add_option("--k-map", options->k_map, "k.pgm or k.yaml as `sfw visibility` writes them")
      ->required();
  command->add_option("--output", options->output, "directory for map.pgm and map.yaml")
      ->required();
  command->callback([options] { runDense(*options); });
}

}  // namespace sfw
