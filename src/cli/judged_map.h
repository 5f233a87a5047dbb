#pragma once

#include <optional>
#include <string>
#include <vector>

#include "structure_from_wifi/evaluation.h"

namespace sfw {

/// A map with its figures, and what to call it.
struct JudgedMap {
  std::string title;
  Grid<CellState> map;
  MapFigures figures;
};

/// A raster that the mapper writes beside the map (map_server yaml, mode scale), if it is there.
std::optional<Grid<float>> readBeside(const std::string& map, const char* name);

/// Reads the map of "TITLE=FILE", and what the mapper wrote beside it, and judges it.
/// @param input  with the truth and the path; its map is replaced
/// @throw InputError as readMap and evaluate, and if there is no title
JudgedMap judgeMap(const std::string& title_and_file, EvaluationInput input);

/// The truth, the maps in this order with the path alone before the last, and their figures, as
/// renderPanels draws them.
std::string picturePanels(const EvaluationInput& input, const Evaluation& evaluation,
                          const std::vector<JudgedMap>& maps, bool with_legend);

}  // namespace sfw
