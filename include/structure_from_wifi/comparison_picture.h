#pragma once

#include <string>

#include "structure_from_wifi/evaluation.h"

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

}  // namespace sfw
