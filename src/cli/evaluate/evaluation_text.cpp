#include "cli/evaluate/evaluation_text.h"

#include <algorithm>
#include <iomanip>
#include <map>
#include <optional>

#include "cli/evaluate/metrics.h"

namespace sfw {
namespace {

constexpr int kTextWidth = 48;
constexpr int kWidth = 12;  // of a column

void printValue(std::ostream& out, std::optional<double> value, int width = kWidth) {
  if (value) {
    out << std::setw(width) << std::fixed << std::setprecision(3) << *value;
  } else {
    out << std::setw(width) << '-';
  }
}

/// A column of the table: the metrics of one map.
struct Column {
  std::string title;
  int width = kWidth;
  std::vector<std::optional<double>> values;

  Column(const std::string& of, const MapMetrics& metrics)
      : title(of), width(std::max(kWidth, static_cast<int>(of.size()) + 2)) {
    forEachMetric(metrics, [&](const char*, const char*, std::optional<double> value) {
      values.push_back(value);
    });
  }
};

}  // namespace

void printTable(std::ostream& out, const Evaluation& evaluation,
                const std::vector<ScoredMap>& beside) {
  out << "truth: " << std::fixed << std::setprecision(2) << evaluation.free_m2 << " m2 free, "
      << evaluation.wall_cells << " wall cells";
  if (evaluation.observed_wall_cells) {
    out << ", " << *evaluation.observed_wall_cells << " of them observed";
  }
  std::vector<Column> columns{{"map", evaluation.map}};
  for (const ScoredMap& scored : beside) {
    columns.emplace_back(scored.title, scored.metrics);
  }
  columns.emplace_back("path only", evaluation.path_only);
  out << "\n\n" << std::left << std::setw(kTextWidth) << "metric" << std::right;
  for (const Column& column : columns) {
    out << std::setw(column.width) << column.title;
  }
  out << '\n';
  std::size_t row = 0;
  forEachMetric(evaluation.map, [&](const char*, const char* text, std::optional<double>) {
    out << std::left << std::setw(kTextWidth) << text << std::right;
    for (const Column& column : columns) {
      printValue(out, column.values[row], column.width);
    }
    out << '\n';
    ++row;
  });
}

void printAblations(std::ostream& out, const MapMetrics& map, const AblationMetrics& ablations) {
  std::map<std::string, Statistics> shifted;
  for (const MapMetrics& one : ablations.shifted_radio) {
    forEachMetric(one, [&](const char* key, const char*, std::optional<double> value) {
      shifted[key].add(value);
    });
  }
  std::map<std::string, std::optional<double>> silent;
  forEachMetric(ablations.no_radio, [&](const char* key, const char*, std::optional<double> value) {
    silent[key] = value;
  });
  out << "\n"
      << std::left << std::setw(kTextWidth) << "ablations" << std::right << std::setw(kWidth)
      << "map" << std::setw(kWidth) << "no radio"
      << "   shifted radio\n";
  forEachMetric(map, [&](const char* key, const char* text, std::optional<double> value) {
    out << std::left << std::setw(kTextWidth) << text << std::right;
    printValue(out, value);
    printValue(out, silent[key]);
    out << "   " << shifted[key].text() << '\n';
  });
}

void printPrediction(std::ostream& out, const PredictionMetrics& metrics) {
  const auto print = [&](const char* text, std::optional<double> mean, double shadowed) {
    out << std::left << std::setw(kTextWidth) << text << std::right;
    printValue(out, mean);
    printValue(out, shadowed);
    out << '\n';
  };
  out << "\n"
      << std::left << std::setw(kTextWidth) << "prediction of hidden stretches, rms error [dB]"
      << std::right << std::setw(kWidth) << "alone" << std::setw(kWidth) << "+ nearest" << '\n';
  print("distance", metrics.distance_db, metrics.distance_shadowed_db);
  print("distance and walls", metrics.walls_db, metrics.walls_shadowed_db);
  print("neither: ordinary kriging", std::nullopt, metrics.kriging_db);
  print("neither: CWirelessPowerGridMap2D of MRPT", std::nullopt, metrics.mrpt_db);
}

}  // namespace sfw
