#include <atomic>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "commands.h"
#include "figures.h"
#include "structure_from_wifi/atomic_file.h"
#include "structure_from_wifi/comparison_picture.h"
#include "structure_from_wifi/config_reader.h"
#include "structure_from_wifi/controls.h"
#include "structure_from_wifi/evaluation.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/map_server.h"
#include "structure_from_wifi/prediction.h"
#include "warnings.h"

namespace sfw {
namespace {

struct EvaluateOptions {
  std::string map;
  std::string truth;
  std::string readings;
  std::string access_points;
  std::string probability;
  bool controls = false;
  bool prediction = false;
  std::string config;
  bool json = false;
  std::string picture;
};

nlohmann::ordered_json toJson(const Evaluation& evaluation) {
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
  json["map"] = figuresJson(evaluation.map);
  json["path_only"] = figuresJson(evaluation.path_only);
  return json;
}

void printValue(std::ostream& out, std::optional<double> value) {
  constexpr int kWidth = 12;
  if (value) {
    out << std::setw(kWidth) << std::fixed << std::setprecision(3) << *value;
  } else {
    out << std::setw(kWidth) << '-';
  }
}

void printTable(std::ostream& out, const Evaluation& evaluation) {
  constexpr int kTextWidth = 48;
  out << "truth: " << std::fixed << std::setprecision(2) << evaluation.free_m2 << " m2 free, "
      << evaluation.wall_cells << " wall cells";
  if (evaluation.observed_wall_cells) {
    out << ", " << *evaluation.observed_wall_cells << " of them observed";
  }
  out << "\n\n"
      << std::left << std::setw(kTextWidth) << "figure" << std::right << std::setw(12) << "map"
      << std::setw(12) << "path only" << '\n';
  std::vector<std::optional<double>> reference;
  forEachFigure(evaluation.path_only, [&](const char*, const char*, std::optional<double> value) {
    reference.push_back(value);
  });
  auto beside = reference.begin();
  forEachFigure(evaluation.map, [&](const char*, const char* text, std::optional<double> value) {
    out << std::left << std::setw(kTextWidth) << text << std::right;
    printValue(out, value);
    printValue(out, *beside++);
    out << '\n';
  });
}

nlohmann::ordered_json toJson(const ControlFigures& controls) {
  nlohmann::ordered_json json{{"no_radio", figuresJson(controls.no_radio)},
                              {"shifted_radio", nlohmann::ordered_json::array()}};
  for (const MapFigures& figures : controls.shifted_radio) {
    json["shifted_radio"].push_back(figuresJson(figures));
  }
  return json;
}

void printControls(std::ostream& out, const MapFigures& map, const ControlFigures& controls) {
  constexpr int kTextWidth = 48;
  std::map<std::string, Statistics> shifted;
  for (const MapFigures& one : controls.shifted_radio) {
    forEachFigure(one, [&](const char* key, const char*, std::optional<double> value) {
      shifted[key].add(value);
    });
  }
  std::map<std::string, std::optional<double>> silent;
  forEachFigure(controls.no_radio, [&](const char* key, const char*, std::optional<double> value) {
    silent[key] = value;
  });
  out << "\n"
      << std::left << std::setw(kTextWidth) << "controls" << std::right << std::setw(12) << "map"
      << std::setw(12) << "no radio"
      << "   shifted radio\n";
  forEachFigure(map, [&](const char* key, const char* text, std::optional<double> value) {
    out << std::left << std::setw(kTextWidth) << text << std::right;
    printValue(out, value);
    printValue(out, silent[key]);
    out << "   " << shifted[key].text() << '\n';
  });
}

/// The controls, if asked for: they map the readings again.
std::optional<ControlFigures> controlsFor(const EvaluateOptions& options,
                                          const EvaluationInput& input,
                                          const std::vector<Reading>& readings) {
  if (!options.controls) {
    return std::nullopt;
  }
  if (options.access_points.empty()) {
    throw InputError("--controls needs --access-points: it maps the readings again");
  }
  const Config config = options.config.empty() ? Config() : readConfig(options.config).config;
  return evaluateControls(input, readings, readAccessPoints(options.access_points), config);
}

nlohmann::ordered_json toJson(const PredictionFigures& figures) {
  return {{"bins", figures.bins},
          {"distance_db", figures.distance},
          {"walls_db", figures.walls},
          {"distance_shadowed_db", figures.distance_shadowed},
          {"walls_shadowed_db", figures.walls_shadowed}};
}

void printPrediction(std::ostream& out, const PredictionFigures& figures) {
  constexpr int kTextWidth = 48;
  const auto print = [&](const char* text, double mean, double shadowed) {
    out << std::left << std::setw(kTextWidth) << text << std::right;
    printValue(out, mean);
    printValue(out, shadowed);
    out << '\n';
  };
  out << "\n"
      << std::left << std::setw(kTextWidth) << "prediction of hidden stretches, rms error [dB]"
      << std::right << std::setw(12) << "alone" << std::setw(12) << "+ nearest" << '\n';
  print("distance", figures.distance, figures.distance_shadowed);
  print("distance and walls", figures.walls, figures.walls_shadowed);
}

/// How well hidden readings can be predicted, if asked for.
std::optional<PredictionFigures> predictionFor(const EvaluateOptions& options,
                                               const std::vector<Reading>& readings) {
  if (!options.prediction) {
    return std::nullopt;
  }
  if (options.access_points.empty()) {
    throw InputError("--prediction needs --access-points: signals are predicted from them");
  }
  const std::atomic<bool> stop{false};
  const auto figures =
      predictHiddenStretches(readings, readAccessPoints(options.access_points), {}, stop);
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
  for (const AccessPoint& access_point : readAccessPoints(options.access_points)) {
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

/// A raster that the mapper writes beside the map, if it is there.
std::optional<Grid<float>> readBeside(const std::string& map, const char* name) {
  const std::filesystem::path beside = std::filesystem::path(map).parent_path() / name;
  return std::filesystem::exists(beside) ? std::optional(readProbabilities(beside.string()))
                                         : std::nullopt;
}

void runEvaluate(const EvaluateOptions& options) {
  if (options.readings.empty()) {
    throw InputError(
        "--readings is missing: the figures are about the room that the path of the readings lies "
        "in");
  }
  const std::vector<Reading> readings = readWithWarnings(options.readings);
  EvaluationInput input{readMap(options.map), readMap(options.truth), {}, {}, {}};
  input.probabilities = options.probability.empty() ? readBeside(options.map, "probability.yaml")
                                                    : readProbabilities(options.probability);
  input.wall_loss = readBeside(options.map, "wall_loss.yaml");
  for (const Reading& reading : readings) {
    input.path.push_back(reading.antenna_in_map);
  }
  if (!options.access_points.empty()) {
    input.access_points = heardAccessPoints(options, readings);
  }
  const Evaluation evaluation = evaluate(input);
  if (!options.picture.empty()) {
    writeAtomically(options.picture, renderComparison(input));
  }
  const std::optional<ControlFigures> controls = controlsFor(options, input, readings);
  const std::optional<PredictionFigures> prediction = predictionFor(options, readings);
  if (!options.json) {
    printTable(std::cout, evaluation);
    if (controls) {
      printControls(std::cout, evaluation.map, *controls);
    }
    if (prediction) {
      printPrediction(std::cout, *prediction);
    }
    return;
  }
  nlohmann::ordered_json json = toJson(evaluation);
  if (controls) {
    json["controls"] = toJson(*controls);
  }
  if (prediction) {
    json["prediction"] = toJson(*prediction);
  }
  std::cout << json.dump(2) << '\n';
}

}  // namespace

void addEvaluateCommand(CLI::App& sfw) {
  auto options = std::make_shared<EvaluateOptions>();
  CLI::App* command =
      sfw.add_subcommand("evaluate", "Compares a map with the truth, beside a map without radio");
  command->add_option("--map", options->map, "Map to judge (map_server yaml)")->required();
  command->add_option("--truth", options->truth, "True map in the same frame (map_server yaml)")
      ->required();
  command->add_option("--readings", options->readings, "CSV that the map was made from: its path");
  command->add_option("--access-points", options->access_points,
                      "YAML; adds the figures about observed walls, those that a ray crosses");
  command->add_option("--probability", options->probability,
                      "Probabilities of being occupied (map_server yaml, mode scale); default: "
                      "probability.yaml beside the map, if there is one");
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
  command->add_flag("--json", options->json, "Print one JSON object instead of a table");
  command->callback([options] { runEvaluate(*options); });
}

}  // namespace sfw
