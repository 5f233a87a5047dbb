#include "cli/evaluate/judged_map.h"

#include <cstdio>
#include <filesystem>

#include "evaluation/comparison_picture.h"
#include "files/map_server.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// "precision 0.92, IoU 0.79, leak 49 %"
std::string noteOf(const MapMetrics& figures) {
  char text[80];
  std::snprintf(text, sizeof text, "precision %.2f, IoU %.2f", figures.free.precision,
                figures.free.iou);
  std::string note = text;
  if (const std::optional<double> leak = figures.observed_leak) {
    std::snprintf(text, sizeof text, ", leak %.0f %%", 100.0 * *leak);
    note += text;
  }
  return note;
}

}  // namespace

void readBeside(const std::string& map, std::filesystem::path probability, EvaluationInput& input) {
  const std::filesystem::path folder = std::filesystem::path(map).parent_path();
  const bool named = !probability.empty();  // then it has to be there
  probability = named ? probability : folder / "probability.yaml";
  const std::filesystem::path wall_loss = folder / "wall_loss.yaml";
  input.probabilities = named || std::filesystem::exists(probability)
                            ? std::optional(readProbabilities(probability.string()))
                            : std::nullopt;
  input.wall_loss = std::filesystem::exists(wall_loss)
                        ? std::optional(readWallLoss(wall_loss.string()))
                        : std::nullopt;
}

ScoredMap judgeMap(const std::string& title_and_file, EvaluationInput input) {
  const std::size_t equals = title_and_file.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw InputError("--beside must be TITLE=FILE; it is '" + title_and_file + "'");
  }
  const std::string file = title_and_file.substr(equals + 1);
  input.map = readMap(file);
  readBeside(file, {}, input);
  const MapMetrics figures = evaluate(input).map;
  return {title_and_file.substr(0, equals), std::move(input.map), figures};
}

std::string picturePanels(const EvaluationInput& input, const Evaluation& evaluation,
                          const std::vector<ScoredMap>& maps, bool with_legend) {
  std::vector<MapPanel> panels;
  for (const ScoredMap& judged : maps) {
    panels.push_back({judged.title, noteOf(judged.figures), judged.map});
  }
  panels.insert(panels.end() - 1,
                {"path alone, no radio", noteOf(evaluation.path_only), pathOnlyMap(input)});
  char truth_note[40];
  std::snprintf(truth_note, sizeof truth_note, "%.0f m² free", evaluation.free_m2);
  return renderPanels(input, truth_note, panels, with_legend);
}

}  // namespace sfw
