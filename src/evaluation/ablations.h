#pragma once

#include <vector>

#include "evaluation/evaluation.h"
#include "structure_from_wifi/belief_map.h"
#include "structure_from_wifi/config.h"
#include "structure_from_wifi/mapper.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Number of shifts of the signals along the path.
constexpr int kRadioShifts = 8;

/// A mapper with readings inserted. @throw InputError as Mapper
Mapper mapperOf(const std::vector<Reading>& readings, const std::vector<AccessPoint>& access_points,
                const Config& config);

/// Shifts the signal strengths of each access point along the path: real signals at wrong places.
///
/// @param shift  1..kRadioShifts; number of (kRadioShifts + 1)-ths of the run, in the order of the
/// readings
std::vector<Reading> withShiftedRadio(const std::vector<Reading>& readings, int shift);

/// Metrics of the same mapper without the true signals. The difference from the metrics of the map
/// is the contribution of the radio.
struct AblationMetrics {
  std::vector<MapMetrics> shifted_radio;  ///< one for each shift
  MapMetrics no_radio;                    ///< the path alone, by the rules of the mapper
};

/// Maps the readings again for each ablation and compares with the truth.
/// @param input  as for the map itself; its map and probabilities are replaced
/// @throw InputError as Mapper and evaluate
AblationMetrics evaluateAblations(const EvaluationInput& input,
                                  const std::vector<Reading>& readings,
                                  const std::vector<AccessPoint>& access_points,
                                  const Config& config);

/// Sets the map and the probabilities of the input on one grid, and removes its wall losses.
void setBelief(const BeliefMap& belief, const BeliefMap& probability, EvaluationInput& input);

/// Sets the map, the probabilities and the wall losses of the input from a snapshot.
void setMap(const Snapshot& snapshot, EvaluationInput& input);

}  // namespace sfw
