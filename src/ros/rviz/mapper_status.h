#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace sfw {

/// What the diagnostics of a mapping nodelet say, ready to be shown.
class MapperStatus {
 public:
  /// One of the nodelet's reports.
  struct Report {
    int level = 0;      ///< of diagnostic_msgs/DiagnosticStatus
    std::string text;   ///< a sentence
    double time_s = 0;  ///< when it came
    std::map<std::string, std::string> values;
  };

  /// Keeps the reports of mapping nodelets among the diagnostics of a robot.
  /// @param now_s  any steady clock [s]
  void insert(const diagnostic_msgs::DiagnosticArray& diagnostics, double now_s);

  /// Names of the mapping nodelets heard so far, without a leading slash.
  std::vector<std::string> nodes() const;

  /// The reports of a node: inputs, transforms, map. The worst comes first, and those of one level
  /// in this order. A node that fell silent has one report, which says so.
  std::vector<Report> reports(const std::string& node, double now_s) const;

  /// A value of the report `map`, or of the others if that lacks it; nothing if none has it.
  std::optional<std::string> value(const std::string& node, const std::string& key) const;

 private:
  std::map<std::string, std::map<std::string, Report>> nodes_;  // by node and task
};

}  // namespace sfw
