#pragma once

#include <actionlib/client/simple_action_client.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <ros/node_handle.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/drive_command.h"
#include "exploration/driver.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Sends the ends of ways as goals to the action `move_base`.
///
/// After a touch it cancels the goal and asks to drive backwards, because move_base finds no way
/// out of a cell that it takes for an obstacle. It does the same when the robot stands for long, as
/// a local planner makes it that finds itself in an obstacle; each second time it drives ahead. If
/// twelve such tries in a row hardly move the robot, it is stuck.
class MoveBaseDriver : public Driver {
 public:
  /// @param node  whose callback queue must not wait for step()
  MoveBaseDriver(const ros::NodeHandle& node, const std::string& map_frame, double speed_m_s);

  /// Goals stay on this part of the map frame [m]. move_base makes no plan to a goal off its map,
  /// so a way that leaves the map is driven up to its rim. The map grows when the robot comes near.
  void setMap(const Box& map);

  void follow(std::vector<Position> way) override;
  void stop() override;
  State step(const RobotPose& pose, bool touching, double now_s) override;

  /// Whether the robot shall obey command() now, and not move_base.
  bool backsOff() const { return backing_; }
  const DriveCommand& command() const { return command_; }

  /// Whether somebody serves the action.
  bool connected() const { return client_->isServerConnected(); }

 private:
  /// Counts an escape from a place. @return false if too many in a row hardly moved the robot
  bool mayEscapeFrom(const Position& wedged);

  std::unique_ptr<actionlib::SimpleActionClient<move_base_msgs::MoveBaseAction>> client_;
  std::string map_frame_;
  double speed_m_s_;
  Box bounds_;  // empty: no map came
  State state_ = State::kIdle;
  DriveCommand command_;
  bool backing_ = false;
  bool ahead_ = true;  // at the last escape, so that the first one goes backwards
  State after_backing_ = State::kBlocked;
  int escapes_ = 0;  // in a row that hardly moved the robot
  std::optional<Position> escaped_from_;
  RobotPose backing_from_;
  double backing_since_s_ = 0.0;
  std::optional<Position> moved_from_;  // while a goal is driven to
  double moved_at_s_ = 0.0;
};

}  // namespace sfw
