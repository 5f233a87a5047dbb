#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/evaluation.h"

namespace sfw {

/// A map with its title and metrics.
struct ScoredMap {
  std::string title;
  Grid<CellState> map;
  MapMetrics metrics;
};

/// Reads the probabilities and wall losses that lie beside a map, if their files exist.
/// @param offset  to subtract from their positions [m]
/// @param probability  file of the probabilities, which must exist; empty: probability.yaml beside
/// the map
/// @throw InputError as readProbabilities and readWallLoss
void readProbabilityAndWallLoss(const std::string& map, std::filesystem::path probability,
                                const Position& offset, EvaluationInput& input);

/// Reads the map of "TITLE=FILE", with the probabilities and wall losses beside it, and scores it.
/// @param offset  to subtract from the positions of the map [m]
/// @param input   truth and path; its map is replaced
/// @throw InputError as readMap and evaluate, and if there is no title
ScoredMap scoreMap(const std::string& title_and_file, const Position& offset,
                   EvaluationInput input);

/// Draws the truth and the maps with their metrics, as renderPanels. The path alone comes before
/// the last map.
std::string picturePanels(const EvaluationInput& input, const Evaluation& evaluation,
                          const std::vector<ScoredMap>& maps, bool with_legend);

}  // namespace sfw
