#include "ros/rviz/mapper_status.h"

#include <diagnostic_msgs/DiagnosticStatus.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

namespace sfw {
namespace {

/// The tasks that tell a mapping nodelet from other nodes with diagnostics.
constexpr std::string_view kTasks[] = {"inputs", "transforms", "map"};

/// The parts of "node: task".
std::optional<std::pair<std::string, std::string>> nodeAndTask(const std::string& name) {
  const std::size_t colon = name.rfind(": ");
  if (colon == std::string::npos) {
    return std::nullopt;
  }
  const std::string task = name.substr(colon + 2);
  if (std::find(std::begin(kTasks), std::end(kTasks), task) == std::end(kTasks)) {
    return std::nullopt;
  }
  const std::size_t begin = name.front() == '/' ? 1 : 0;
  return std::make_pair(name.substr(begin, colon - begin), task);
}

}  // namespace

void MapperStatus::insert(const diagnostic_msgs::DiagnosticArray& diagnostics, double now_s) {
  for (const diagnostic_msgs::DiagnosticStatus& status : diagnostics.status) {
    const auto name = nodeAndTask(status.name);
    if (!name) {
      continue;
    }
    Report report{status.level, status.message, now_s, {}};
    for (const diagnostic_msgs::KeyValue& value : status.values) {
      report.values[value.key] = value.value;
    }
    nodes_[name->first][name->second] = std::move(report);
  }
}

std::vector<std::string> MapperStatus::nodes() const {
  std::vector<std::string> names;
  for (const auto& [name, reports] : nodes_) {
    // Other programs have tasks of such names, too, but not all of them.
    if (reports.size() == std::size(kTasks)) {
      names.push_back(name);
    }
  }
  return names;
}

std::vector<MapperStatus::Report> MapperStatus::reports(const std::string& node,
                                                        double now_s) const {
  constexpr double kSilentAfterS = 5.0;  // diagnostics come once a second
  const auto found = nodes_.find(node);
  std::vector<Report> result;
  if (found != nodes_.end()) {
    for (const std::string_view task : kTasks) {
      const auto report = found->second.find(std::string(task));
      if (report != found->second.end() && now_s - report->second.time_s <= kSilentAfterS) {
        result.push_back(report->second);
      }
    }
  }
  if (result.empty()) {
    const std::string text =
        node.empty() ? "No mapping node is heard on /diagnostics: start one."
                     : "The node '" + node + "' sends no diagnostics: look whether it runs.";
    return {{diagnostic_msgs::DiagnosticStatus::STALE, text, now_s, {}}};
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Report& a, const Report& b) { return a.level > b.level; });
  return result;
}

std::optional<std::string> MapperStatus::value(const std::string& node,
                                               const std::string& key) const {
  const auto found = nodes_.find(node);
  if (found == nodes_.end()) {
    return std::nullopt;
  }
  for (auto task = std::rbegin(kTasks); task != std::rend(kTasks); ++task) {
    const auto report = found->second.find(std::string(*task));
    if (report == found->second.end()) {
      continue;
    }
    const auto value = report->second.values.find(key);
    if (value != report->second.values.end()) {
      return value->second;
    }
  }
  return std::nullopt;
}

}  // namespace sfw
