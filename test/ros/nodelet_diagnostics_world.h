#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <rosgraph_msgs/Log.h>

#include <algorithm>
#include <string>
#include <vector>

#include "mapping_nodelet_world.h"

namespace sfw {

/// A world that hears what its nodelet tells: /diagnostics and the log.
class NodeletDiagnosticsWorld : public NodeletWorld {
 protected:
  void SetUp() override {
    NodeletWorld::SetUp();
    ros::NodeHandle node;
    diagnostics_ = node.subscribe<diagnostic_msgs::DiagnosticArray>(
        "/diagnostics", 100, [this](const diagnostic_msgs::DiagnosticArrayConstPtr& array) {
          for (const diagnostic_msgs::DiagnosticStatus& status : array->status) {
            statuses_.push_back(status);
          }
        });
    log_ = node.subscribe<rosgraph_msgs::Log>(
        "/rosout", 1000, [this](const rosgraph_msgs::LogConstPtr& log) { logs_.push_back(*log); });
  }

  static constexpr int kScans = 60;  // of a drive

  /// Readings along a line of 3 m.
  void drive(double start_s) {
    for (int i = 0; i < kScans; ++i) {
      sendPose(start_s + 0.05 * i, 0.05 * i, 1.0);
      sendScan(start_s + 0.05 * i, {{kNear, -50.0F - static_cast<float>(i % 7)}});
    }
  }

  bool mapAppears() {
    return spinUntil(
        [&] { return map_ && std::count(map_->data.begin(), map_->data.end(), 0) > 0; },
        30.0 * kSlowdown);
  }

  /// Waits for a status of this world's nodelet with some words.
  bool hears(const std::string& task, int level, const std::string& words,
             const std::string& nodelet = "mapping") {
    const std::string name = name_.substr(1) + "/" + nodelet + ": " + task;
    return spinUntil(
        [&] {
          return std::any_of(statuses_.begin(), statuses_.end(), [&](const auto& status) {
            return status.name == name && static_cast<int>(status.level) == level &&
                   status.message.find(words) != std::string::npos;
          });
        },
        20.0 * kSlowdown);
  }

  /// Waits for a value in the diagnostics of this world's nodelet.
  bool hasValue(const std::string& task, const std::string& key, const std::string& value) {
    const std::string name = name_.substr(1) + "/mapping: " + task;
    return spinUntil(
        [&] {
          return std::any_of(statuses_.begin(), statuses_.end(), [&](const auto& status) {
            return status.name == name &&
                   std::any_of(status.values.begin(), status.values.end(), [&](const auto& pair) {
                     return pair.key == key && pair.value == value;
                   });
          });
        },
        20.0 * kSlowdown);
  }

  std::ptrdiff_t logged(int level, const std::string& words) const {
    return std::count_if(logs_.begin(), logs_.end(), [&](const rosgraph_msgs::Log& log) {
      return static_cast<int>(log.level) == level && log.msg.find(words) != std::string::npos;
    });
  }

  bool logs(int level, const std::string& words) {
    return spinUntil([&] { return logged(level, words) > 0; }, 20.0 * kSlowdown);
  }

  std::vector<diagnostic_msgs::DiagnosticStatus> statuses_;
  std::vector<rosgraph_msgs::Log> logs_;
  ros::Subscriber diagnostics_, log_;
};

}  // namespace sfw
