#include "cli/bench/bench_table.h"

#include <algorithm>

#include "cli/evaluate/metrics.h"

namespace sfw {
namespace {

using Json = nlohmann::json;

struct Column {
  const char* key;
  const char* title;
};
constexpr Column kColumns[] = {{"knows_wall_f1", "knows the wall F1"},
                               {"plans_through_walls", "plans through walls"},
                               {"places_reached", "places reached"},
                               {"free_precision", "free P"},
                               {"free_iou", "free IoU"},
                               {"wall_f1_2", "wall F1"},
                               {"observed_wall_recall_2", "observed wall recall"},
                               {"wall_in_free", "walls in free space"},
                               {"walls_called_free", "walls called free"},
                               {"auc", "AUC"},
                               {"radio_auc", "radio AUC"},
                               {"radio_auc_off_path", "radio AUC off path"},
                               {"radio_wall_f1_2", "radio walls F1"},
                               {"radio_wall_f1_4", "within 0.2 m"}};

/// A row of a table: one kind of map on one level, over plans and seeds.
struct Row {
  std::string path;
  std::string level;
  std::string made_by;
  std::vector<std::pair<std::string, Statistics>> metrics;  // in order of first appearance
};

/// The element for which `is_wanted` holds; if there is none, a new one of `made()`.
template <class T, class Predicate, class Make>
T& findOrAdd(std::vector<T>& all, Predicate&& is_wanted, Make&& made) {
  const auto found = std::find_if(all.begin(), all.end(), is_wanted);
  return found != all.end() ? *found : all.emplace_back(made());
}

void addMetrics(const Json& metrics, Row& row) {
  for (const auto& [key, value] : metrics.items()) {
    const auto& name = key;
    auto& metric = findOrAdd(
        row.metrics, [&](const auto& known) { return known.first == name; },
        [&] { return std::make_pair(name, Statistics()); });
    metric.second.add(value.is_number() ? std::optional(value.get<double>()) : std::nullopt);
  }
}

/// All rows, in order of first appearance.
std::vector<Row> rowsOf(const std::vector<BenchResult>& results) {
  std::vector<Row> rows;
  for (const BenchResult& result : results) {
    for (const Json& map : result.maps) {
      const auto made_by = map.at("made_by").get<std::string>();
      Row& row = findOrAdd(
          rows,
          [&](const Row& known) {
            return known.path == result.job.path && known.level == result.job.level &&
                   known.made_by == made_by;
          },
          [&] {
            return Row{result.job.path, result.job.level, made_by, {}};
          });
      addMetrics(map.at("metrics"), row);
    }
  }
  return rows;
}

std::vector<std::string> pathsOf(const std::vector<Row>& rows) {
  std::vector<std::string> paths;
  for (const Row& row : rows) {
    findOrAdd(
        paths, [&](const std::string& path) { return path == row.path; }, [&] { return row.path; });
  }
  return paths;
}

std::string line(const Row& row) {
  std::string text = "| " + row.level + " | " + row.made_by + " |";
  for (const Column& column : kColumns) {
    const auto found = std::find_if(row.metrics.begin(), row.metrics.end(),
                                    [&](const auto& metric) { return metric.first == column.key; });
    text += " " + (found != row.metrics.end() ? found->second : Statistics()).text() + " |";
  }
  return text + "\n";
}

Json summaryOf(const Row& row) {
  Json json{{"path", row.path}, {"noise", row.level}, {"made_by", row.made_by}};
  for (const auto& [name, sample] : row.metrics) {
    json["metrics"][name] = sample.count() == 0 ? Json()
                                                : Json{{"mean", sample.mean()},
                                                       {"sd", sample.standardDeviation()},
                                                       {"count", sample.count()}};
  }
  return json;
}

}  // namespace

Json toJson(const BenchJob& job) {
  return {{"plan", job.plan}, {"noise", job.level}, {"path", job.path}, {"seed", job.seed}};
}

std::string toMarkdown(const BenchReport& report) {
  std::string text;
  const std::vector<Row> rows = rowsOf(report.results);
  for (const std::string& path : pathsOf(rows)) {
    text += "Path `" + path + "`, mean ± standard deviation over plans and seeds:\n\n";
    text += "| noise | map |";
    std::string rule = "|---|---|";
    for (const Column& column : kColumns) {
      text += std::string(" ") + column.title + " |";
      rule += "---|";
    }
    text += "\n" + rule + "\n";
    for (const Row& row : rows) {
      text += row.path == path ? line(row) : "";
    }
    text += "\n";
  }
  for (const BenchFailure& failure : report.failures) {
    text += "Left out: " + toText(failure.job) + ": " + failure.reason + "\n";
  }
  return text;
}

std::string toJson(const BenchReport& report) {
  Json json{{"summary", Json::array()}, {"recordings", Json::array()}, {"failed", Json::array()}};
  for (const Row& row : rowsOf(report.results)) {
    json["summary"].push_back(summaryOf(row));
  }
  for (const BenchResult& result : report.results) {
    json["recordings"].push_back(toJson(result.job));
    json["recordings"].back()["maps"] = result.maps;
  }
  for (const BenchFailure& failure : report.failures) {
    json["failed"].push_back(toJson(failure.job));
    json["failed"].back()["reason"] = failure.reason;
  }
  return json.dump(1) + "\n";
}

}  // namespace sfw
