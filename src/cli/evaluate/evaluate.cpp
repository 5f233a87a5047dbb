#include <atomic>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/commands.h"
#include "cli/evaluate/evaluation_text.h"
#include "cli/evaluate/metrics.h"
#include "cli/evaluate/scored_map.h"
#include "cli/warnings.h"
#include "evaluation/ablations.h"
#include "evaluation/comparison_picture.h"
#include "evaluation/cross_validation.h"
#include "evaluation/evaluation.h"
#include "files/atomic_file.h"
#include "files/map_server.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

struct EvaluateOptions {
  std::string map;
  std::string truth;
  std::string readings;
  std::string access_points;
  std::string probability;
  std::vector<std::string> beside;
  bool ablations = false;
  bool prediction = false;
  std::string config;
  bool json = false;
  std::string picture;
  std::string panels;
  std::string title = "map";
  bool no_legend = false;
};

nlohmann::json toJson(const Evaluation& evaluation, const std::vector<ScoredMap>& beside) {
  nlohmann::json json;
  json["free_m2"] = evaluation.free_m2;
  json["wall_cells"] = evaluation.wall_cells;
  json["observed_wall_cells"] = nullptr;
  if (evaluation.observed_wall_cells) {
    json["observed_wall_cells"] = *evaluation.observed_wall_cells;
  }
  json["probability_cells"] = nullptr;
  if (evaluation.map.probability) {
    json["probability_cells"] = evaluation.map.probability->cells;
  }
  json["map"] = metricsJson(evaluation.map);
  for (const ScoredMap& scored : beside) {
    json["beside"][scored.title] = metricsJson(scored.metrics);
  }
  json["path_only"] = metricsJson(evaluation.path_only);
  return json;
}

nlohmann::json toJson(const AblationMetrics& ablations) {
  nlohmann::json json{{"no_radio", metricsJson(ablations.no_radio)},
                      {"shifted_radio", nlohmann::json::array()}};
  for (const MapMetrics& metrics : ablations.shifted_radio) {
    json["shifted_radio"].push_back(metricsJson(metrics));
  }
  return json;
}

/// The metrics of the ablations, if --ablations is given. Each ablation maps the readings again.
std::optional<AblationMetrics> ablationsFor(const EvaluateOptions& options,
                                            const EvaluationInput& input,
                                            const std::vector<Reading>& readings,
                                            const std::vector<AccessPoint>& access_points) {
  if (!options.ablations) {
    return std::nullopt;
  }
  if (options.access_points.empty()) {
    throw InputError("--ablations needs --access-points: it maps the readings again");
  }
  return evaluateAblations(input, readings, access_points, configWithWarnings(options.config));
}

nlohmann::json toJson(const PredictionMetrics& metrics) {
  return {{"bins", metrics.bins},
          {"distance_db", metrics.distance_db},
          {"walls_db", metrics.walls_db},
          {"distance_shadowed_db", metrics.distance_shadowed_db},
          {"walls_shadowed_db", metrics.walls_shadowed_db}};
}

/// The errors of predicted signals, if --prediction is given.
std::optional<PredictionMetrics> predictionFor(const EvaluateOptions& options,
                                               const std::vector<Reading>& readings,
                                               const std::vector<AccessPoint>& access_points) {
  if (!options.prediction) {
    return std::nullopt;
  }
  if (options.access_points.empty()) {
    throw InputError("--prediction needs --access-points: their positions predict the signals");
  }
  const std::atomic<bool> stop{false};
  const auto metrics = predictHiddenStretches(readings, access_points, {}, stop);
  if (!metrics) {
    throw InputError(options.readings +
                     ": --prediction needs a longer drive, and all positions within a building; "
                     "leave the option out");
  }
  return metrics;
}

/// Positions of the access points in the readings. Only they have rays.
std::vector<Position> accessPointsWithReadings(const EvaluateOptions& options,
                                               const std::vector<Reading>& readings,
                                               const std::vector<AccessPoint>& access_points) {
  std::set<Bssid> in_readings;
  for (const Reading& reading : readings) {
    in_readings.insert(reading.bssid);
  }
  std::vector<Position> positions;
  for (const AccessPoint& access_point : access_points) {
    if (in_readings.count(access_point.bssid) != 0 && access_point.position_known) {
      positions.push_back(access_point.position);
    }
  }
  if (positions.empty()) {
    throw InputError(options.access_points + ": no access point with a position has a reading in " +
                     options.readings);
  }
  return positions;
}

void writePictures(const EvaluateOptions& options, const EvaluationInput& input,
                   const Evaluation& evaluation, const std::vector<ScoredMap>& beside) {
  if (!options.picture.empty()) {
    writeAtomically(options.picture, renderComparison(input));
  }
  if (!options.panels.empty()) {
    std::vector<ScoredMap> shown = beside;
    shown.push_back({options.title, input.map, evaluation.map});
    writeAtomically(options.panels, picturePanels(input, evaluation, shown, !options.no_legend));
  }
}

/// Scores the maps of --beside.
/// @param input  truth and path
std::vector<ScoredMap> scoreBeside(const EvaluateOptions& options, const EvaluationInput& input) {
  std::vector<ScoredMap> beside;
  for (const std::string& title_and_file : options.beside) {
    ScoredMap scored = scoreMap(title_and_file, input);
    if (std::any_of(beside.begin(), beside.end(),
                    [&](const ScoredMap& other) { return other.title == scored.title; })) {
      throw InputError("--beside has the title '" + scored.title + "' twice");
    }
    beside.push_back(std::move(scored));
  }
  return beside;
}

void printMetrics(const EvaluateOptions& options, const Evaluation& evaluation,
                  const std::vector<ScoredMap>& beside,
                  const std::optional<AblationMetrics>& ablations,
                  const std::optional<PredictionMetrics>& prediction) {
  if (options.json) {
    nlohmann::json json = toJson(evaluation, beside);
    if (ablations) {
      json["ablations"] = toJson(*ablations);
    }
    if (prediction) {
      json["prediction"] = toJson(*prediction);
    }
    std::cout << json.dump(2) << std::endl;
    return;
  }
  printTable(std::cout, evaluation, beside);
  if (ablations) {
    printAblations(std::cout, evaluation.map, *ablations);
  }
  if (prediction) {
    printPrediction(std::cout, *prediction);
  }
  std::cout << std::flush;
}

void run(const EvaluateOptions& options) {
  const std::vector<Reading> readings = readWithWarnings(options.readings).readings;
  EvaluationInput input{readMap(options.map), readMap(options.truth), {}, {}, {}};
  readProbabilityAndWallLoss(options.map, options.probability, input);
  if (!input.map.geometry.box().intersects(input.truth.geometry.box())) {
    warn(options.map + " and " + options.truth +
         " do not overlap: check that both are in the same frame");
  }
  for (const Reading& reading : readings) {
    input.path.push_back(reading.antenna_in_map);
  }
  std::vector<AccessPoint> access_points;
  if (!options.access_points.empty()) {
    access_points = accessPointsWithWarnings(options.access_points);
    input.access_points = accessPointsWithReadings(options, readings, access_points);
  }
  const Evaluation evaluation = evaluate(input);
  const std::vector<ScoredMap> beside = scoreBeside(options, input);
  const std::optional<AblationMetrics> ablations =
      ablationsFor(options, input, readings, access_points);
  const std::optional<PredictionMetrics> prediction =
      predictionFor(options, readings, access_points);
  printMetrics(options, evaluation, beside, ablations, prediction);
  // Pictures come last, so that the metrics are printed even if a picture cannot be written.
  writePictures(options, input, evaluation, beside);
}

}  // namespace

void runEvaluate(Options& options) {
  EvaluateOptions evaluate;
  options.addRequired("map", "FILE", evaluate.map, "map to score (map_server YAML)");
  options.addRequired("truth", "FILE", evaluate.truth,
                      "true map in the same frame (map_server YAML)");
  options.addRequired("readings", "FILE", evaluate.readings,
                      "CSV that the map was made from; the metrics cover the room that its path "
                      "lies in");
  options.add("access-points", "FILE", evaluate.access_points,
              "YAML; adds the metrics of observed walls, those that a ray crosses");
  options.add("probability", "FILE", evaluate.probability,
              "probabilities of being occupied (map_server YAML, mode scale); default: "
              "probability.yaml beside the map, if it exists");
  options.addList("beside", "TITLE=FILE", evaluate.beside,
                  "another map of the same place to score (map_server YAML)");
  options.addFlag("ablations", evaluate.ablations,
                  "also map without radio, and with the signals shifted along the path by 1/9 .. "
                  "8/9 of the run; the difference to these maps is the radio's contribution");
  options.addOldName("controls", "ablations");
  options.addFlag("prediction", evaluate.prediction,
                  "hide stretches of 3 m of the readings and predict them from the others, by "
                  "distance alone and with walls; the gain from walls is the radio's knowledge");
  options.add("config", "FILE", evaluate.config,
              "settings for --ablations; give the file that the map was made with");
  options.add("picture", "FILE", evaluate.picture,
              "PNG to write: the map over the truth, with walls found, missed and called free");
  options.add("panels", "FILE", evaluate.panels,
              "PNG to write: the truth, the maps of --beside, the path alone and the map, side by "
              "side");
  options.add("title", "TEXT", evaluate.title, "title of the map among the panels");
  options.addFlag("no-legend", evaluate.no_legend, "draw no legend below the panels");
  options.addFlag("json", evaluate.json, "print one JSON object instead of a table");
  if (options.parse()) {
    run(evaluate);
  }
}

}  // namespace sfw
