#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "evaluation/evaluation.h"

namespace sfw {

/// A metric of a group; absent if the group is.
template <class Group, class Value>
std::optional<double> within(const std::optional<Group>& group, Value Group::*value) {
  return group ? std::optional<double>((*group).*value) : std::nullopt;
}

/// Calls `visit(key, text, value)` for each metric, in the order of the table.
template <class Visitor>
void forEachMetric(const MapMetrics& m, Visitor&& visit) {
  const std::optional<WallKnowledge>& walls = m.navigation.walls;
  const std::optional<RouteMetrics>& routes = m.navigation.routes;
  visit("knows_wall_f1", "knows the wall: F1", within(walls, &WallKnowledge::f1));
  visit("knows_wall_auc", "knows the wall: area under the curve",
        within(walls, &WallKnowledge::auc));
  visit("knows_wall_precision", "knows the wall: precision",
        within(walls, &WallKnowledge::precision));
  visit("knows_wall_recall", "knows the wall: recall", within(walls, &WallKnowledge::recall));
  visit("plans_through_walls", "plans through walls", within(routes, &RouteMetrics::through_walls));
  visit("places_reached", "places reached", within(routes, &RouteMetrics::reached));
  visit("no_plan", "no plan", within(routes, &RouteMetrics::no_plan));
  visit("detour_median", "detours: median length over true shortest",
        within(routes, &RouteMetrics::detour_median));
  visit("detours_over_1m", "detours: over 1 m longer than needed",
        within(routes, &RouteMetrics::detours_over_1m));
  visit("free_precision", "free: precision", m.free.precision);
  visit("free_precision_tolerant", "free: precision within 0.1 m", m.free.tolerant_precision);
  visit("free_recall", "free: recall", m.free.recall);
  visit("free_iou", "free: intersection over union", m.free.iou);
  visit("beyond_m2", "free beyond 0.3 m of the path: area found [m2]", m.free.beyond_m2);
  visit("beyond_precision", "free beyond 0.3 m of the path: precision", m.free.beyond_precision);
  visit("wall_precision_1", "wall within 0.05 m: precision",
        within(m.wall_one_cell, &WallMetrics::precision));
  visit("wall_recall_1", "wall within 0.05 m: recall",
        within(m.wall_one_cell, &WallMetrics::recall));
  visit("wall_f1_1", "wall within 0.05 m: F1", within(m.wall_one_cell, &WallMetrics::f1));
  visit("observed_wall_recall_1", "wall within 0.05 m: recall, observed",
        within(m.wall_one_cell, &WallMetrics::observed_recall));
  visit("wall_precision_2", "wall within 0.1 m: precision",
        within(m.wall_two_cells, &WallMetrics::precision));
  visit("wall_recall_2", "wall within 0.1 m: recall",
        within(m.wall_two_cells, &WallMetrics::recall));
  visit("wall_f1_2", "wall within 0.1 m: F1", within(m.wall_two_cells, &WallMetrics::f1));
  visit("observed_wall_recall_2", "wall within 0.1 m: recall, observed",
        within(m.wall_two_cells, &WallMetrics::observed_recall));
  visit("wall_in_free", "wall cells that lie in free space", m.wall_in_free);
  visit("walls_called_free", "observed walls called free", m.observed_walls_called_free);
  visit("all_walls_called_free", "all walls called free", m.walls_called_free);
  visit("auc", "probability: area under the curve",
        within(m.probability, &ProbabilityMetrics::auc));
  visit("brier", "probability: Brier score", within(m.probability, &ProbabilityMetrics::brier));
  visit("log_loss", "probability: log-loss [nat]",
        within(m.probability, &ProbabilityMetrics::log_loss));
  visit("radio_auc", "wall loss by radio alone: area under the curve",
        within(m.radio, &RadioMetrics::auc));
  visit("radio_auc_off_path", "wall loss beyond 0.3 m of the path: area under the curve",
        within(m.radio, &RadioMetrics::auc_off_path));
  visit("radio_wall_f1_2", "walls by radio alone: F1 within 0.1 m",
        within(m.radio, &RadioMetrics::wall_f1_two_cells));
  visit("radio_wall_f1_4", "walls by radio alone: F1 within 0.2 m",
        within(m.radio, &RadioMetrics::wall_f1_four_cells));
}

/// All metrics by their keys; null where a metric is absent.
inline nlohmann::json metricsJson(const MapMetrics& metrics) {
  nlohmann::json json;
  forEachMetric(metrics, [&](const char* key, const char*, std::optional<double> value) {
    json[key] = value ? nlohmann::json(*value) : nlohmann::json();
  });
  return json;
}

/// Mean and standard deviation of a metric. Absent values do not count.
class Statistics {
 public:
  void add(std::optional<double> value) {
    if (value) {
      ++count_;
      sum_ += *value;
      squares_ += *value * *value;
    }
  }

  int count() const { return count_; }
  double mean() const { return sum_ / count_; }
  double standardDeviation() const {
    return std::sqrt(std::max(0.0, squares_ / count_ - mean() * mean()));
  }

  std::string text() const {
    if (count_ == 0) {
      return "-";
    }
    char text[32];
    std::snprintf(text, sizeof text, "%.3f ± %.3f", mean(), standardDeviation());
    return text;
  }

 private:
  int count_ = 0;
  double sum_ = 0.0;
  double squares_ = 0.0;
};

}  // namespace sfw
