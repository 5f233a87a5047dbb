#pragma once

#include <string>
#include <vector>

#include "evaluation/evaluation.h"

namespace sfw {

/// Draws a map over the truth as a PNG. Colours distinguish free space and walls that the map finds
/// or misses. They also mark walls called free and walls drawn in free space. The picture has the
/// path, the access points and a legend.
///
/// Walls agree within 0.1 m, as in the metrics of evaluate(). Unknown cells of the truth stay
/// empty. Map and truth lie in one frame; their grids may differ.
/// @throw InputError if the truth has no known cell; std::runtime_error if Cairo fails.
/// O(cells of the truth).
std::string renderComparison(const EvaluationInput& input);

/// One map of renderPanels.
struct MapPanel {
  std::string title;
  std::string note;  ///< a short line below the title
  Grid<CellState> map;
};

/// Draws the truth and maps side by side as a PNG: one row of panels of the same area and scale,
/// with titles and a scale bar. Faint lines show true walls that a map lacks.
///
/// @param truth_note  line below the truth's title
/// @param with_legend  draw the meaning of the colours
/// @throw as renderComparison. O(cells of the truth and of the maps).
std::string renderPanels(const EvaluationInput& input, const std::string& truth_note,
                         const std::vector<MapPanel>& maps, bool with_legend);

}  // namespace sfw
