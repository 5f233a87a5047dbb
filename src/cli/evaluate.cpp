#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "commands.h"
#include "structure_from_wifi/config_reader.h"
#include "structure_from_wifi/evaluation.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/map_server.h"
#include "structure_from_wifi/reading_io.h"

namespace sfw {
namespace {

struct EvaluateOptions {
  std::string map;
  std::string truth;
  std::string readings;
  std::string access_points;
  std::string probability;
  bool json = false;
};

/// A figure of a group that may be absent as a whole.
template <class Group, class Value>
std::optional<double> within(const std::optional<Group>& group, Value Group::*value) {
  return group ? std::optional<double>((*group).*value) : std::nullopt;
}

/// Calls `visit(key, text, value)` for each figure, in the order of the table.
template <class Visitor>
void forEachFigure(const MapFigures& m, Visitor&& visit) {
  visit("free_precision", "free: precision", m.free.precision);
  visit("free_precision_tolerant", "free: precision within 0.1 m", m.free.tolerant_precision);
  visit("free_recall", "free: recall", m.free.recall);
  visit("free_iou", "free: intersection over union", m.free.iou);
  visit("beyond_m2", "free beyond 0.3 m of the path: area found [m2]", m.free.beyond_m2);
  visit("beyond_precision", "free beyond 0.3 m of the path: precision", m.free.beyond_precision);
  visit("wall_precision_1", "wall within 0.05 m: precision",
        within(m.wall_one_cell, &WallFigures::precision));
  visit("wall_recall_1", "wall within 0.05 m: recall",
        within(m.wall_one_cell, &WallFigures::recall));
  visit("wall_f1_1", "wall within 0.05 m: F1", within(m.wall_one_cell, &WallFigures::f1));
  visit("observed_wall_recall_1", "wall within 0.05 m: recall, observed",
        within(m.wall_one_cell, &WallFigures::observed_recall));
  visit("wall_precision_2", "wall within 0.1 m: precision",
        within(m.wall_two_cells, &WallFigures::precision));
  visit("wall_recall_2", "wall within 0.1 m: recall",
        within(m.wall_two_cells, &WallFigures::recall));
  visit("wall_f1_2", "wall within 0.1 m: F1", within(m.wall_two_cells, &WallFigures::f1));
  visit("observed_wall_recall_2", "wall within 0.1 m: recall, observed",
        within(m.wall_two_cells, &WallFigures::observed_recall));
  visit("wall_in_free", "wall cells that lie in free space", m.wall_in_free);
  visit("leak", "leak: observed walls called free", m.observed_leak);
  visit("leak_all_walls", "leak: all walls called free", m.leak);
  visit("auc", "probability: area under the curve",
        within(m.probability, &ProbabilityFigures::auc));
  visit("brier", "probability: Brier score", within(m.probability, &ProbabilityFigures::brier));
  visit("log_loss", "probability: log-loss [nat]",
        within(m.probability, &ProbabilityFigures::log_loss));
}

nlohmann::ordered_json toJson(const MapFigures& figures) {
  nlohmann::ordered_json json;
  forEachFigure(figures, [&](const char* key, const char*, std::optional<double> value) {
    json[key] = value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
  });
  return json;
}

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
  json["map"] = toJson(evaluation.map);
  json["path_only"] = toJson(evaluation.path_only);
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

ReadingFile readWithNotes(const std::string& file) {
  ReadingFile readings = readReadings(file);
  for (const auto& [reason, skipped] : readings.skipped) {
    std::cerr << "sfw: warning: " << file << ": " << skipped.count << " rows skipped: " << reason
              << " (first: " << skipped.first << ")\n";
  }
  return readings;
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
    if (heard.count(access_point.bssid) != 0) {
      positions.push_back(access_point.position);
    }
  }
  if (positions.empty()) {
    throw InputError(options.access_points + ": none of its access points is heard in " +
                     options.readings);
  }
  return positions;
}

std::optional<Grid<float>> readProbabilitiesFor(const EvaluateOptions& options) {
  if (!options.probability.empty()) {
    return readProbabilities(options.probability);
  }
  const std::filesystem::path beside =
      std::filesystem::path(options.map).parent_path() / "probability.yaml";
  return std::filesystem::exists(beside) ? std::optional(readProbabilities(beside.string()))
                                         : std::nullopt;
}

void runEvaluate(const EvaluateOptions& options) {
  if (options.readings.empty()) {
    throw InputError(
        "--readings is missing: the figures are about the room that the path of the readings lies "
        "in");
  }
  const ReadingFile file = readWithNotes(options.readings);
  EvaluationInput input{
      readMap(options.map), readMap(options.truth), {}, {}, readProbabilitiesFor(options)};
  for (const Reading& reading : file.readings) {
    input.path.push_back(reading.antenna_in_map);
  }
  if (!options.access_points.empty()) {
    input.access_points = heardAccessPoints(options, file.readings);
  }
  const Evaluation evaluation = evaluate(input);
  if (options.json) {
    std::cout << toJson(evaluation).dump(2) << '\n';
  } else {
    printTable(std::cout, evaluation);
  }
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
  command->add_flag("--json", options->json, "Print one JSON object instead of a table");
  command->callback([options] { runEvaluate(*options); });
}

}  // namespace sfw
