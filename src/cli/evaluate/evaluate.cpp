#include <algorithm>
#include <atomic>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/evaluate/evaluation_text.h"
#include "cli/evaluate/located_access_points.h"
#include "cli/evaluate/map_report.h"
#include "cli/evaluate/metrics.h"
#include "cli/evaluate/scored_map.h"
#include "cli/evaluate/summary_text.h"
#include "cli/far_positions.h"
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
  std::string path;
  std::string access_points;
  std::string probability;
  std::vector<std::string> beside;
  bool all = false;
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

/// The settings that the map was made with, as far as known.
Config settingsFor(const EvaluateOptions& options) {
  const std::optional<Config> reported =
      options.config.empty() ? reportedSettings(options.map) : std::nullopt;
  return reported ? *reported : configWithWarnings(options.config);
}

/// The metrics of the ablations, if --ablations is given. Each ablation maps the readings again.
std::optional<AblationMetrics> ablationsFor(const EvaluateOptions& options,
                                            const EvaluationInput& input,
                                            const std::vector<Reading>& readings,
                                            const std::vector<AccessPoint>& access_points) {
  if (!options.ablations) {
    return std::nullopt;
  }
  if (options.access_points.empty() && !isReportedWithoutTable(options.map)) {
    throw InputError("--ablations needs --access-points: it maps the readings again");
  }
  return evaluateAblations(input, readings, access_points, settingsFor(options));
}

nlohmann::json toJson(const PredictionMetrics& metrics) {
  return {{"bins", metrics.bins},
          {"distance_db", metrics.distance_db},
          {"walls_db", metrics.walls_db},
          {"distance_shadowed_db", metrics.distance_shadowed_db},
          {"walls_shadowed_db", metrics.walls_shadowed_db},
          {"kriging_db", metrics.kriging_db},
          {"mrpt_db", metrics.mrpt_db}};
}

/// The errors of predicted signals, if --prediction is given.
std::optional<PredictionMetrics> predictionFor(const EvaluateOptions& options,
                                               const std::vector<Reading>& readings,
                                               const std::vector<AccessPoint>& located) {
  if (!options.prediction) {
    return std::nullopt;
  }
  if (located.empty()) {
    throw InputError("--prediction needs --access-points with positions: they predict the signals");
  }
  const std::atomic<bool> stop{false};
  const auto metrics = predictHiddenStretches(readings, located, {}, stop);
  if (!metrics) {
    throw InputError(options.readings +
                     ": --prediction needs a longer drive, and all positions within a building; "
                     "leave the option out");
  }
  return metrics;
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
std::vector<ScoredMap> scoreBeside(const EvaluateOptions& options, const Position& offset,
                                   const EvaluationInput& input) {
  std::vector<ScoredMap> beside;
  for (const std::string& title_and_file : options.beside) {
    ScoredMap scored = scoreMap(title_and_file, offset, input);
    if (std::any_of(beside.begin(), beside.end(),
                    [&](const ScoredMap& other) { return other.title == scored.title; })) {
      throw InputError("--beside has the title '" + scored.title + "' twice");
    }
    beside.push_back(std::move(scored));
  }
  return beside;
}

/// All that is printed.
struct Results {
  Evaluation evaluation;
  std::vector<ScoredMap> beside;
  std::optional<AblationMetrics> ablations;
  std::optional<PredictionMetrics> prediction;
};

void printJson(const Results& results) {
  nlohmann::json json = toJson(results.evaluation, results.beside);
  if (results.ablations) {
    json["ablations"] = toJson(*results.ablations);
  }
  if (results.prediction) {
    json["prediction"] = toJson(*results.prediction);
  }
  std::cout << json.dump(2) << std::endl;
}

std::vector<SummaryColumn> columnsOf(const Results& results) {
  std::vector<SummaryColumn> columns{{"this map", {results.evaluation.map}}};
  for (const ScoredMap& scored : results.beside) {
    columns.push_back({scored.title, {scored.metrics}});
  }
  if (results.ablations) {
    columns.push_back({"no radio", {results.ablations->no_radio}});
    columns.push_back({"shifted radio", results.ablations->shifted_radio});
  }
  columns.push_back({"path alone", {results.evaluation.path_only}});
  return columns;
}

void printTables(const EvaluateOptions& options, const EvaluationInput& input,
                 const Results& results) {
  printSummary(std::cout, *input.navigation, columnsOf(results));
  if (!input.probabilities) {
    std::cout << "AUC:    left out; it needs probability.yaml beside the map, or --probability\n";
  }
  if (!results.ablations) {
    std::cout << "radio:  --ablations with --access-points shows what maps without the true radio "
                 "know; it maps the readings nine times\n";
  }
  if (options.all) {
    std::cout << '\n';
    printTable(std::cout, results.evaluation, results.beside);
    if (results.ablations) {
      printAblations(std::cout, results.evaluation.map, *results.ablations);
    }
  } else {
    std::cout << "more:   --all prints the metrics of cells\n";
  }
  if (results.prediction) {
    printPrediction(std::cout, *results.prediction);
  }
  std::cout << std::flush;
}

/// Truth, path and map, without access points.
/// @param offset  that was subtracted from the readings
EvaluationInput inputFor(const EvaluateOptions& options, const std::vector<Reading>& readings,
                         const Position& offset) {
  EvaluationInput input{
      near(readMap(options.map), offset), near(readMap(options.truth), offset), {}, {}, {}};
  readProbabilityAndWallLoss(options.map, options.probability, offset, input);
  if (!input.map.geometry.box().intersects(input.truth.geometry.box())) {
    warn(options.map + " and " + options.truth +
         " do not overlap: check that both are in the same frame");
  }
  for (const Reading& reading : readings) {
    input.path.push_back(reading.antenna_in_map);
  }
  input.navigation = std::make_shared<const NavigationEvaluation>(input.truth, input.path);
  return input;
}

void run(const EvaluateOptions& options) {
  std::vector<Reading> readings = readWithWarnings(options.readings, options.path).readings;
  std::stable_sort(readings.begin(), readings.end(),  // each robot has a path of its own
                   [](const Reading& a, const Reading& b) { return a.robot < b.robot; });
  const Position offset = offsetOf(readings);  // no metric depends on it
  subtract(offset, readings);
  EvaluationInput input = inputFor(options, readings, offset);
  std::vector<AccessPoint> access_points;
  std::vector<AccessPoint> located;
  if (!options.access_points.empty()) {
    access_points = accessPointsWithWarnings(options.access_points);
  }
  if (!access_points.empty()) {
    located = locatedAccessPoints(access_points, readings, options.map, options.access_points);
    subtract(offset, access_points);
    subtract(offset, located);
  }
  for (const AccessPoint& access_point : located) {
    input.access_points.push_back(access_point.position);
  }
  const Results results{evaluate(input), scoreBeside(options, offset, input),
                        ablationsFor(options, input, readings, access_points),
                        predictionFor(options, readings, located)};
  if (options.json) {
    printJson(results);
  } else {
    printTables(options, input, results);
  }
  // Pictures come last, so that the metrics are printed even if a picture cannot be written.
  writePictures(options, input, results.evaluation, results.beside);
}

}  // namespace

void runEvaluate(Options& options) {
  EvaluateOptions evaluate;
  options.addRequired("map", "FILE", evaluate.map, "map to score (map_server YAML)");
  options.addRequired("truth", "FILE", evaluate.truth,
                      "true map in the same frame (map_server YAML)");
  options.addRequired("readings", "FILE", evaluate.readings,
                      "CSV that the map was made from; its path says where to ask the map");
  options.add("path", "FILE", evaluate.path,
              "CSV with the columns stamp, x, y: positions for readings that have none");
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
              "settings for --ablations; default: those in report.json beside the map");
  options.add("picture", "FILE", evaluate.picture,
              "PNG to write: the map over the truth, with walls found, missed and called free");
  options.add("panels", "FILE", evaluate.panels,
              "PNG to write: the truth, the maps of --beside, the path alone and the map, side by "
              "side");
  options.add("title", "TEXT", evaluate.title, "title of the map among the panels");
  options.addFlag("no-legend", evaluate.no_legend, "draw no legend below the panels");
  options.addFlag("all", evaluate.all,
                  "also print the metrics of cells: free space, walls, probabilities, radio");
  options.addFlag("json", evaluate.json, "print all metrics as one JSON object instead of a table");
  if (options.parse()) {
    run(evaluate);
  }
}

}  // namespace sfw
