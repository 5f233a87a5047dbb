#include "ros/rviz/mapper_status.h"

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <gtest/gtest.h>

namespace sfw::test {
namespace {

using diagnostic_msgs::DiagnosticArray;
using diagnostic_msgs::DiagnosticStatus;

DiagnosticStatus status(const std::string& name, std::int8_t level, const std::string& message) {
  DiagnosticStatus result;
  result.name = name;
  result.level = level;
  result.message = message;
  return result;
}

/// The reports of a node that waits for tf.
DiagnosticArray waitingForTf(const std::string& node) {
  DiagnosticArray array;
  array.status = {status(node + ": inputs", DiagnosticStatus::OK, "Readings arrive."),
                  status(node + ": transforms", DiagnosticStatus::ERROR, "tf lacks a transform."),
                  status(node + ": map", DiagnosticStatus::WARN, "There is no map yet.")};
  diagnostic_msgs::KeyValue value;
  value.key = "readings";
  value.value = "17";
  array.status[2].values.push_back(value);
  return array;
}

TEST(MapperStatus, TellsTheWorstReportFirst) {
  MapperStatus mappers;
  mappers.insert(waitingForTf("mapping"), 10.0);
  const auto reports = mappers.reports("mapping", 11.0);
  ASSERT_EQ(reports.size(), 3U);
  EXPECT_EQ(reports[0].text, "tf lacks a transform.");
  EXPECT_EQ(reports[1].text, "There is no map yet.");
  EXPECT_EQ(reports[2].text, "Readings arrive.");
}

TEST(MapperStatus, FindsMappersAmongOtherNodes) {
  MapperStatus mappers;
  DiagnosticArray others;
  others.status = {status("camera: inputs", DiagnosticStatus::OK, "Fine."),
                   status("battery", DiagnosticStatus::OK, "Full."), status("", 0, "")};
  mappers.insert(others, 1.0);
  EXPECT_TRUE(mappers.nodes().empty());
  mappers.insert(waitingForTf("/robot2/mapping"), 2.0);
  mappers.insert(waitingForTf("robot1/mapping"), 2.0);
  EXPECT_EQ(mappers.nodes(), (std::vector<std::string>{"robot1/mapping", "robot2/mapping"}));
}

TEST(MapperStatus, GivesValues) {
  MapperStatus mappers;
  mappers.insert(waitingForTf("mapping"), 10.0);
  EXPECT_EQ(mappers.value("mapping", "readings"), "17");
  EXPECT_FALSE(mappers.value("mapping", "free area"));
  EXPECT_FALSE(mappers.value("other", "readings"));
}

TEST(MapperStatus, SaysWhenANodeIsSilent) {
  MapperStatus mappers;
  EXPECT_EQ(mappers.reports("", 0.0).at(0).text,
            "No mapping node is heard on /diagnostics: start one.");
  mappers.insert(waitingForTf("mapping"), 10.0);
  EXPECT_EQ(mappers.reports("mapping", 14.0).size(), 3U);
  const auto silent = mappers.reports("mapping", 20.0);
  ASSERT_EQ(silent.size(), 1U);
  EXPECT_EQ(silent[0].level, DiagnosticStatus::STALE);
  EXPECT_EQ(silent[0].text, "The node 'mapping' sends no diagnostics: look whether it runs.");
}

}  // namespace
}  // namespace sfw::test
