#include <atomic>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/commands.h"
#include "cli/evaluate/evaluation_text.h"
#include "cli/evaluate/figures.h"
#include "cli/evaluate/judged_map.h"
#include "cli/warnings.h"
#include "evaluation/ablations.h"
#include "evaluation/comparison_picture.h"
#include "evaluation/cross_validation.h"
#include "evaluation/evaluation.h"
#include "files/atomic_file.h"
#include "files/map_server.h"
#include "structure_from_wifi/access_points_io.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/settings_io.h"

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
  for (const ScoredMap& judged : beside) {
    json["beside"][judged.title] = metricsJson(judged.figures);
  }
  json["path_only"] = metricsJson(evaluation.path_only);
  return json;
}

nlohmann::json toJson(const AblationMetrics& controls) {
  nlohmann::json json{{"no_radio", metricsJson(controls.no_radio)},
                      {"shifted_radio", nlohmann::json::array()}};
  for (const MapMetrics& figures : controls.shifted_radio) {
    json["shifted_radio"].push_back(metricsJson(figures));
  }
  return json;
}

/// The controls, if asked for: they map the readings again.
std::optional<AblationMetrics> controlsFor(const EvaluateOptions& options,
                                           const EvaluationInput& input,
                                           const std::vector<Reading>& readings) {
  if (!options.ablations) {
    return std::nullopt;
  }
  if (options.access_points.empty()) {
    throw InputError("--ablations needs --access-points: it maps the readings again");
  }
  const Config config = options.config.empty() ? Config() : readConfig(options.config).config;
  return evaluateControls(input, readings, readAccessPoints(options.access_points).access_points,
                          config);
}

nlohmann::json toJson(const PredictionMetrics& figures) {
  return {{"bins", figures.bins},
          {"distance_db", figures.distance},
          {"walls_db", figures.walls},
          {"distance_shadowed_db", figures.distance_shadowed},
          {"walls_shadowed_db", figures.walls_shadowed}};
}

/// How well hidden readings can be predicted, if asked for.
std::optional<PredictionMetrics> predictionFor(const EvaluateOptions& options,
                                               const std::vector<Reading>& readings) {
  if (!options.prediction) {
    return std::nullopt;
  }
  if (options.access_points.empty()) {
    throw InputError("--prediction needs --access-points: signals are predicted from them");
  }
  const std::atomic<bool> stop{false};
  const auto figures = predictHiddenStretches(
      readings, readAccessPoints(options.access_points).access_points, {}, stop);
  if (!figures) {
    throw InputError(options.readings + ": too short a drive for --prediction, or too far");
  }
  return figures;
}

/// Where the access points stand that the readings speak of: rays lead to no others.
std::vector<Position> heardAccessPoints(const EvaluateOptions& options,
                                        const std::vector<Reading>& readings) {
  std::set<Bssid> heard;
  for (const Reading& reading : readings) {
    heard.insert(reading.bssid);
  }
  std::vector<Position> positions;
  for (const AccessPoint& access_point : readAccessPoints(options.access_points).access_points) {
    if (heard.count(access_point.bssid) != 0 && access_point.position_known) {
      positions.push_back(access_point.position);
    }
  }
  if (positions.empty()) {
    throw InputError(options.access_points + ": none of its access points is heard in " +
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

void run(const EvaluateOptions& options) {
  const std::vector<Reading> readings = readWithWarnings(options.readings).readings;
  EvaluationInput input{readMap(options.map), readMap(options.truth), {}, {}, {}};
  readBeside(options.map, options.probability, input);
  if (!input.map.geometry.box().intersects(input.truth.geometry.box())) {
    warn(options.map + " and " + options.truth +
         " lie nowhere at the same place: are the two in the same frame?");
  }
  for (const Reading& reading : readings) {
    input.path.push_back(reading.antenna_in_map);
  }
  if (!options.access_points.empty()) {
    input.access_points = heardAccessPoints(options, readings);
  }
  const Evaluation evaluation = evaluate(input);
  std::vector<ScoredMap> beside;
  for (const std::string& title_and_file : options.beside) {
    ScoredMap judged = judgeMap(title_and_file, input);
    if (std::any_of(beside.begin(), beside.end(),
                    [&](const ScoredMap& other) { return other.title == judged.title; })) {
      throw InputError("--beside has the title '" + judged.title + "' twice");
    }
    beside.push_back(std::move(judged));
  }
  const std::optional<AblationMetrics> controls = controlsFor(options, input, readings);
  const std::optional<PredictionMetrics> prediction = predictionFor(options, readings);
  if (options.json) {
    nlohmann::json json = toJson(evaluation, beside);
    if (controls) {
      json["ablations"] = toJson(*controls);
    }
    if (prediction) {
      json["prediction"] = toJson(*prediction);
    }
    std::cout << json.dump(2) << std::endl;
  } else {
    printTable(std::cout, evaluation, beside);
    if (controls) {
      printControls(std::cout, evaluation.map, *controls);
    }
    if (prediction) {
      printPrediction(std::cout, *prediction);
    }
    std::cout << std::flush;
  }
  writePictures(options, input, evaluation, beside);  // last: figures are there if it fails
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
  options.addFormerName("controls", "ablations");
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
