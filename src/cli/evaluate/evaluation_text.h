#pragma once

#include <ostream>
#include <vector>

#include "cli/evaluate/scored_map.h"
#include "evaluation/ablations.h"
#include "evaluation/cross_validation.h"
#include "evaluation/evaluation.h"

namespace sfw {

/// Prints a column of metrics for the map, for each map beside it and for the path alone.
void printTable(std::ostream& out, const Evaluation& evaluation,
                const std::vector<ScoredMap>& beside);

/// Prints the metrics of a map beside those of its ablations.
void printAblations(std::ostream& out, const MapMetrics& map, const AblationMetrics& ablations);

/// Prints the errors of predicted signals [dB].
void printPrediction(std::ostream& out, const PredictionMetrics& metrics);

}  // namespace sfw
