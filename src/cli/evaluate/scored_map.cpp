#include "cli/evaluate/scored_map.h"

#include <cstdio>
#include <filesystem>

#include "cli/far_positions.h"
#include "evaluation/comparison_picture.h"
#include "files/map_server.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// "IoU 0.79, walls called free 49 %": as much as fits above a panel
std::string noteOf(const MapMetrics& metrics) {
  char text[80];
  std::snprintf(text, sizeof text, "IoU %.2f", metrics.free.iou);
  std::string note = text;
  if (const std::optional<double> called_free = metrics.observed_walls_called_free) {
    std::snprintf(text, sizeof text, ", walls called free %.0f %%", 100.0 * *called_free);
    note += text;
  }
  return note;
}

}  // namespace

void readProbabilityAndWallLoss(const std::string& map, std::filesystem::path probability,
                                const Position& offset, EvaluationInput& input) {
  const std::filesystem::path folder = std::filesystem::path(map).parent_path();
  const bool named = !probability.empty();  // then the file must exist
  probability = named ? probability : folder / "probability.yaml";
  const std::filesystem::path wall_loss = folder / "wall_loss.yaml";
  input.probabilities = named || std::filesystem::exists(probability)
                            ? std::optional(near(readProbabilities(probability.string()), offset))
                            : std::nullopt;
  input.wall_loss_db = std::filesystem::exists(wall_loss)
                           ? std::optional(near(readWallLoss(wall_loss.string()), offset))
                           : std::nullopt;
}

ScoredMap scoreMap(const std::string& title_and_file, const Position& offset,
                   EvaluationInput input) {
  const std::size_t equals = title_and_file.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw InputError("--beside must be TITLE=FILE; it is '" + title_and_file + "'");
  }
  const std::string file = title_and_file.substr(equals + 1);
  input.map = near(readMap(file), offset);
  readProbabilityAndWallLoss(file, {}, offset, input);
  const MapMetrics metrics = evaluate(input).map;
  return {title_and_file.substr(0, equals), std::move(input.map), metrics};
}

std::string picturePanels(const EvaluationInput& input, const Evaluation& evaluation,
                          const std::vector<ScoredMap>& maps, bool with_legend) {
  std::vector<MapPanel> panels;
  panels.reserve(maps.size() + 1);  // and the path alone
  for (const ScoredMap& scored : maps) {
    panels.push_back({scored.title, noteOf(scored.metrics), scored.map});
  }
  panels.insert(panels.end() - 1,
                {"path alone, no radio", noteOf(evaluation.path_only), pathOnlyMap(input)});
  char truth_note[40];
  std::snprintf(truth_note, sizeof truth_note, "%.0f m² free", evaluation.free_m2);
  return renderPanels(input, truth_note, panels, with_legend);
}

}  // namespace sfw
