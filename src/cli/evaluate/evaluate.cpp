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
  bool controls = false;
  bool prediction = false;
  std::string config;
  bool json = false;
  std::string picture;
  std::string panels;
  std::string title = "map";
  bool no_legend = false;
};

nlohmann::ordered_json toJson(const Evaluation& evaluation, const std::vector<ScoredMap>& beside) {
  nlohmann::ordered_json json;
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

nlohmann::ordered_json toJson(const AblationMetrics& controls) {
  nlohmann::ordered_json json{{"no_radio", metricsJson(controls.no_radio)},
                              {"shifted_radio", nlohmann::ordered_json::array()}};
  for (const MapMetrics& figures : controls.shifted_radio) {
    json["shifted_radio"].push_back(metricsJson(figures));
  }
  return json;
}

/// The controls, if asked for: they map the readings again.
std::optional<AblationMetrics> controlsFor(const EvaluateOptions& options,
                                           const EvaluationInput& input,
                                           const std::vector<Reading>& readings) {
  if (!options.controls) {
    return std::nullopt;
  }
  if (options.access_points.empty()) {
    throw InputError("--controls needs --access-points: it maps the readings again");
  }
  const Config config = options.config.empty() ? Config() : readConfig(options.config).config;
  return evaluateControls(input, readings, readAccessPoints(options.access_points).access_points,
                          config);
}

nlohmann::ordered_json toJson(const PredictionMetrics& figures) {
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

void runEvaluate(const EvaluateOptions& options) {
  if (options.readings.empty()) {
    throw InputError(
        "--readings is missing: the figures are about the room that the path of the readings lies "
        "in");
  }
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
    nlohmann::ordered_json json = toJson(evaluation, beside);
    if (controls) {
      json["controls"] = toJson(*controls);
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

void addEvaluateCommand(CLI::App& sfw) {
  auto options = std::make_shared<EvaluateOptions>();
  CLI::App* command =
      sfw.add_subcommand("evaluate", "Compares a map with the truth, beside a map without radio");
  command->add_option("--map", options->map, "Map to judge (map_server yaml)")->required();
  command->add_option("--truth", options->truth, "True map in the same frame (map_server yaml)")
      ->required();
  command->add_option("--readings", options->readings,
                      "CSV that the map was made from: its path; required");
  command->add_option("--access-points", options->access_points,
                      "YAML; adds the figures about observed walls, those that a ray crosses");
  command->add_option("--probability", options->probability,
                      "Probabilities of being occupied (map_server yaml, mode scale); default: "
                      "probability.yaml beside the map, if there is one");
  command->add_option("--beside", options->beside,
                      "TITLE=FILE; another map of the place to judge too (map_server yaml); may be "
                      "repeated");
  command->add_flag("--controls", options->controls,
                    "Map again without radio, and with the signals moved along the path by 1/9 .. "
                    "8/9 of the run; what the map owes to the radio is the distance to these");
  command->add_flag("--prediction", options->prediction,
                    "Hide stretches of 3 m of the readings and predict them from the others, by "
                    "distance alone and with walls; what walls gain is what the radio knows");
  command->add_option("--config", options->config,
                      "Settings for --controls, as the map was made with");
  command->add_option(
      "--picture", options->picture,
      "PNG to write: the map laid over the truth, walls found, missed, called free");
  command->add_option("--panels", options->panels,
                      "PNG to write: the truth, the maps of --beside, the path alone and the map, "
                      "side by side");
  command->add_option("--title", options->title, "of the map among the panels")
      ->capture_default_str();
  command->add_flag("--no-legend", options->no_legend, "leave it out below the panels");
  command->add_flag("--json", options->json, "Print one JSON object instead of a table");
  command->callback([options] { runEvaluate(*options); });
}

}  // namespace sfw
