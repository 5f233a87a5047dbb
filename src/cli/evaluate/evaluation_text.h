#pragma once

#include <ostream>
#include <vector>

#include "cli/evaluate/judged_map.h"
#include "evaluation/ablations.h"
#include "evaluation/cross_validation.h"
#include "evaluation/evaluation.h"

namespace sfw {

/// The figures of a map, of those beside it and of the path alone, a column each.
void printTable(std::ostream& out, const Evaluation& evaluation,
                const std::vector<ScoredMap>& beside);

/// The figures of a map beside those of its controls.
void printControls(std::ostream& out, const MapMetrics& map, const AblationMetrics& controls);

void printPrediction(std::ostream& out, const PredictionMetrics& figures);

}  // namespace sfw
