#pragma once

#include <vector>

#include "evaluation/evaluation.h"
#include "structure_from_wifi/belief_map.h"
#include "structure_from_wifi/config.h"
#include "structure_from_wifi/mapper.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// How many shifts of the radio the controls try.
constexpr int kRadioShifts = 8;

/// A real signal at wrong places: each access point's signal strengths moved along the path by
/// `shift` of kRadioShifts + 1 parts of its run, in the order of the readings.
std::vector<Reading> withShiftedRadio(const std::vector<Reading>& readings, int shift);

/// The figures that the same mapper reaches with less than the truth to hear: what it owes to the
/// radio is its distance from them.
struct AblationMetrics {
  std::vector<MapMetrics> shifted_radio;  ///< one for each shift
  MapMetrics no_radio;                    ///< the path alone by the mapper's own rules
};

/// Maps the readings again for each control and compares with the truth.
/// @param input  as for the map itself; its map and probabilities are replaced
/// @throw InputError as Mapper and evaluate
AblationMetrics evaluateControls(const EvaluationInput& input, const std::vector<Reading>& readings,
                                 const std::vector<AccessPoint>& access_points,
                                 const Config& config);

/// The map and probabilities of a belief, for evaluate(), without wall losses.
void setBelief(const BeliefMap& belief, EvaluationInput& input);

/// The same of a mapper's belief, with the wall losses that it found.
void setMap(const Snapshot& snapshot, EvaluationInput& input);

}  // namespace sfw
