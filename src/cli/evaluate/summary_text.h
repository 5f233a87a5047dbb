#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "evaluation/evaluation.h"

namespace sfw {

/// A column of the summary: one map, or several whose mean it shows.
struct SummaryColumn {
  std::string title;
  std::vector<MapMetrics> maps;
};

/// Prints whether a robot can use each map, and what is good.
void printSummary(std::ostream& out, const NavigationEvaluation& navigation,
                  const std::vector<SummaryColumn>& columns);

}  // namespace sfw
