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
                const std::vector<JudgedMap>& beside);

/// The figures of a map beside those of its controls.
void printControls(std::ostream& out, const MapFigures& map, const ControlFigures& controls);

void printPrediction(std::ostream& out, const PredictionFigures& figures);

}  // namespace sfw
