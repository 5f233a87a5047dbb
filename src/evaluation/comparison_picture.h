#pragma once

#include <string>
#include <vector>

#include "evaluation/evaluation.h"

namespace sfw {

/// A PNG for people that lays a map over the truth: free space found and missed, walls found and
/// missed, walls that the map calls free, walls that the map has in free space; the path, the
/// access points and a legend.
///
/// Walls agree within 0.1 m, as in the figures of evaluate(). What the truth does not know is left
/// out. Map and truth lie in one frame; their grids may differ.
/// @throw InputError if the truth has no known cell; std::runtime_error if Cairo fails.
/// O(cells of the truth).
std::string renderComparison(const EvaluationInput& input);

/// A map to be shown beside others.
struct MapPanel {
  std::string title;
  std::string note;  ///< a short line below the title
  Grid<CellState> map;
};

/// A PNG for people of the truth, with path and access points, and maps beside it: one row of
/// panels at one scale, cut alike, with titles and a scale bar. True walls show faintly where a map
/// has none.
///
/// @param truth_note  line below the truth's title
/// @param with_legend  what the colours mean; one row of several may do without
/// @throw as renderComparison. O(cells of the truth and of the maps).
std::string renderPanels(const EvaluationInput& input, const std::string& truth_note,
                         const std::vector<MapPanel>& maps, bool with_legend);

}  // namespace sfw
