#include "evaluation/ablations.h"

#include <map>

#include "grid/for_each_cell.h"
#include "structure_from_wifi/mapper.h"

namespace sfw {

Mapper mapperOf(const std::vector<Reading>& readings, const std::vector<AccessPoint>& access_points,
                const Config& config) {
  Mapper mapper(config, access_points);
  for (const Reading& reading : readings) {
    mapper.insert(reading);
  }
  return mapper;
}

std::vector<Reading> withShiftedRadio(const std::vector<Reading>& readings, int shift) {
  std::map<Bssid, std::vector<std::size_t>> series;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    series[readings[i].bssid].push_back(i);
  }
  std::vector<Reading> shifted = readings;
  for (const auto& [bssid, indices] : series) {
    const std::size_t offset =
        indices.size() * static_cast<std::size_t>(shift) / (kRadioShifts + 1);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      shifted[indices[i]].rssi_dbm = readings[indices[(i + offset) % indices.size()]].rssi_dbm;
    }
  }
  return shifted;
}

AblationMetrics evaluateAblations(const EvaluationInput& input,
                                  const std::vector<Reading>& readings,
                                  const std::vector<AccessPoint>& access_points,
                                  const Config& config) {
  AblationMetrics ablations;
  EvaluationInput ablation = input;
  for (int shift = 1; shift <= kRadioShifts; ++shift) {
    const Mapper mapper = mapperOf(withShiftedRadio(readings, shift), access_points, config);
    setMap(*mapper.infer(), ablation);
    ablations.shifted_radio.push_back(evaluate(ablation).map);
  }
  const auto no_radio = mapperOf(readings, access_points, config).inferWithoutRadio();
  setBelief(no_radio->belief, no_radio->probability, ablation);
  ablations.no_radio = evaluate(ablation).map;
  return ablations;
}

void setBelief(const BeliefMap& belief, const BeliefMap& probability, EvaluationInput& input) {
  const GridGeometry& geometry = belief.geometry();
  input.map = Grid<CellState>(geometry);
  input.probabilities = Grid<float>(geometry);
  input.wall_loss_db.reset();
  forEachCell(geometry, [&](Cell c) {
    input.map[c] = belief.state(c);
    (*input.probabilities)[c] = probability.occupied(c);
  });
}

void setMap(const Snapshot& snapshot, EvaluationInput& input) {
  setBelief(snapshot.belief, snapshot.probability, input);
  if (snapshot.tomography) {
    input.wall_loss_db = snapshot.tomography->wall_loss;
  }
}

}  // namespace sfw
