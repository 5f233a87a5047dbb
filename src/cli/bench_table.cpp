#include "bench_table.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "figures.h"

namespace sfw {
namespace {

struct Column {
  const char* key;
  const char* title;
};
constexpr Column kColumns[] = {{"free_precision", "free P"},
                               {"free_iou", "free IoU"},
                               {"wall_f1_2", "wall F1"},
                               {"observed_wall_recall_2", "observed wall recall"},
                               {"wall_in_free", "walls in free space"},
                               {"leak", "leak"},
                               {"auc", "AUC"}};

std::optional<double> figure(const MapFigures& figures, const std::string& key) {
  std::optional<double> found;
  forEachFigure(figures, [&](const char* name, const char*, std::optional<double> value) {
    found = key == name ? value : found;
  });
  return found;
}

std::string row(const std::vector<BenchResult>& results, const std::string& level,
                const std::string& path, BenchmarkMethod method) {
  std::string text = "| " + level + " | " + nameOf(method) + " |";
  for (const Column& column : kColumns) {
    Sample sample;
    for (const BenchResult& result : results) {
      for (const auto& [made_by, figures] : result.figures) {
        if (result.level == level && result.path == path && made_by == method) {
          sample.add(figure(figures, column.key));
        }
      }
    }
    text += " " + sample.text() + " |";
  }
  return text + "\n";
}

/// The values of a field in order of first appearance.
template <class Field>
std::vector<std::string> distinct(const std::vector<BenchResult>& results, Field&& field) {
  std::vector<std::string> values;
  for (const BenchResult& result : results) {
    if (std::find(values.begin(), values.end(), field(result)) == values.end()) {
      values.push_back(field(result));
    }
  }
  return values;
}

}  // namespace

std::string toMarkdown(const std::vector<BenchResult>& results) {
  std::string text;
  const auto levels = distinct(results, [](const BenchResult& r) { return r.level; });
  for (const std::string& path : distinct(results, [](const BenchResult& r) { return r.path; })) {
    text += "Path `" + path + "`, mean ± standard deviation over plans and seeds:\n\n";
    text += "| noise | method |";
    std::string rule = "|---|---|";
    for (const Column& column : kColumns) {
      text += std::string(" ") + column.title + " |";
      rule += "---|";
    }
    text += "\n" + rule + "\n";
    for (const std::string& level : levels) {
      for (const BenchmarkMethod method : benchmarkMethods()) {
        text += row(results, level, path, method);
      }
    }
    text += "\n";
  }
  return text;
}

std::string toJson(const std::vector<BenchResult>& results) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const BenchResult& result : results) {
    for (const auto& [method, figures] : result.figures) {
      json.push_back({{"plan", result.plan},
                      {"noise", result.level},
                      {"path", result.path},
                      {"seed", result.seed},
                      {"method", nameOf(method)},
                      {"figures", figuresJson(figures)}});
    }
  }
  return json.dump(1) + "\n";
}

}  // namespace sfw
