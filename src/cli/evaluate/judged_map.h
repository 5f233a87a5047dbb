#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/evaluation.h"

namespace sfw {

/// A map with its figures, and what to call it.
struct ScoredMap {
  std::string title;
  Grid<CellState> map;
  MapMetrics figures;
};

/// Adds the probabilities and wall losses that the mapper writes beside a map, where they are.
/// @param probability  file of the probabilities; empty: the one beside the map
/// @throw InputError as readProbabilities and readWallLoss
void readBeside(const std::string& map, std::filesystem::path probability, EvaluationInput& input);

/// Reads the map of "TITLE=FILE", and what the mapper wrote beside it, and judges it.
/// @param input  with the truth and the path; its map is replaced
/// @throw InputError as readMap and evaluate, and if there is no title
ScoredMap judgeMap(const std::string& title_and_file, EvaluationInput input);

/// The truth, the maps in this order with the path alone before the last, and their figures, as
/// renderPanels draws them.
std::string picturePanels(const EvaluationInput& input, const Evaluation& evaluation,
                          const std::vector<ScoredMap>& maps, bool with_legend);

}  // namespace sfw
