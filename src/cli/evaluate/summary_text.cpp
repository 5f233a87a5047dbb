#include "cli/evaluate/summary_text.h"

#include <algorithm>
#include <optional>

#include "cli/evaluate/metrics.h"
#include "files/text.h"

namespace sfw {
namespace {

struct Row {
  const char* key;
  const char* text;
  bool percent;
  const char* good;
};
constexpr Row kRows[] = {
    {"knows_wall_f1", "knows the wall: F1", false, "1 is perfect, 0 knows no wall"},
    {"knows_wall_auc", "knows the wall: AUC", false, "1 is perfect, 0.5 is chance"},
    {"plans_through_walls", "plans through walls", true, "0 % is perfect"},
    {"places_reached", "places reached", true, "100 % is perfect"},
    {"no_plan", "no plan", true, "0 % is perfect; a robot stays where it is"},
    {"detour_median", "detours: median length over true shortest", false,
     "1 is perfect; below 1, plans pass closer to walls"},
    {"detours_over_1m", "detours: over 1 m longer than needed", true, "0 % is perfect"}};

constexpr int kTextWidth = 43;
constexpr int kWidth = 12;  // of a column

std::optional<double> meanOf(const std::string& key, const std::vector<MapMetrics>& maps) {
  Statistics statistics;
  for (const MapMetrics& metrics : maps) {
    forEachMetric(metrics, [&](const char* name, const char*, std::optional<double> value) {
      if (key == name) {
        statistics.add(value);
      }
    });
  }
  return statistics.count() == 0 ? std::nullopt : std::optional(statistics.mean());
}

std::string valueText(std::optional<double> value, bool percent) {
  if (!value) {
    return "-";
  }
  return percent ? formatted("%.0f %%", 100.0 * *value) : formatted("%.2f", *value);
}

std::string cell(const std::string& text, const std::string& title) {
  return formatted("%*s", std::max(kWidth, static_cast<int>(title.size()) + 2), text.c_str());
}

}  // namespace

void printSummary(std::ostream& out, const NavigationEvaluation& navigation,
                  const std::vector<SummaryColumn>& columns) {
  out << std::string(kTextWidth, ' ');
  for (const SummaryColumn& column : columns) {
    out << cell(column.title, column.title);
  }
  out << "   what is good\n";
  for (const Row& row : kRows) {
    out << formatted("%-*s", kTextWidth, row.text);
    for (const SummaryColumn& column : columns) {
      out << cell(valueText(meanOf(row.key, column.maps), row.percent), column.title);
    }
    out << "   " << row.good << '\n';
  }
  out << "\nwalls:  " << navigation.pairs().count() << " pairs of places of the path, "
      << navigation.pairs().walls() << " with a true wall between";
  out << "\nroutes: " << navigation.routes().count()
      << " between places that the truth connects, within 2 m of the path\n";
}

}  // namespace sfw
