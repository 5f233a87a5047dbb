#include "ros/exploration/exploration_nodelet.h"

#include <geometry_msgs/Twist.h>
#include <tf2/exceptions.h>

#include <cmath>
#include <pluginlib/class_list_macros.hpp>
#include <sstream>

#include "ros/conversion/cloud_points.h"
#include "ros/conversion/parameters.h"
#include "ros/mapping/localization.h"

namespace sfw {
namespace {

constexpr double kPeriod = 0.1;        // of steps [s]
constexpr double kOldestPose = 1.0;    // with an older transform the robot stops [s]
constexpr double kPressed = 0.3;       // a point is touched this long after its message [s]
constexpr double kBumperReach = 0.15;  // points farther from the robot's rim are not touched [m]
constexpr double kWarningPeriod = 10.0;

}  // namespace

ExplorationNodelet::~ExplorationNodelet() {
  if (spinner_) {
    spinner_->stop();
  }
  if (pilot_) {
    pilot_->pause();
    drive(false);
  }
}

void ExplorationNodelet::onInit() {
  try {
    settings_ = explorationSettingsFromYaml(parametersOf(getPrivateNodeHandle()));
    for (const std::string& warning : settings_.warnings) {
      NODELET_WARN_STREAM(warning);
    }
    ros::NodeHandle node(getNodeHandle());
    ros::NodeHandle own(getPrivateNodeHandle());
    node.setCallbackQueue(&queue_);
    own.setCallbackQueue(&queue_);
    transforms_.emplace();
    listener_.emplace(*transforms_, node);
    makeDriver(node);
    active_ = settings_.autostart;
    connect(node, own);
    spinner_.emplace(1, &queue_);
    spinner_->start();
  } catch (const std::exception& error) {
    std::istringstream problems(error.what());
    for (std::string problem; std::getline(problems, problem);) {
      NODELET_ERROR_STREAM("The exploration cannot start: " << problem);
    }
  }
}

void ExplorationNodelet::makeDriver(const ros::NodeHandle& node) {
  Driver* driver = nullptr;
  if (settings_.driver == "move_base") {
    move_base_ =
        std::make_unique<MoveBaseDriver>(node, settings_.map_frame, settings_.robot.speed_m_s);
    driver = move_base_.get();
  } else {
    WayDriver::Config config;
    config.speed_m_s = settings_.robot.speed_m_s;
    config.yaw_rate_rad_s = settings_.robot.yaw_rate_rad_s;
    way_driver_ = std::make_unique<WayDriver>(config);
    driver = way_driver_.get();
  }
  pilot_.emplace(settings_.robot, settings_.limits, *driver);
}

void ExplorationNodelet::connect(ros::NodeHandle& node, ros::NodeHandle& own) {
  constexpr std::uint32_t kQueue = 10;
  constexpr bool kLatched = true;
  commands_ = node.advertise<geometry_msgs::Twist>("cmd_vel", kQueue);
  markers_ = node.advertise<visualization_msgs::MarkerArray>("exploration", 1, kLatched);
  finished_ = own.advertise<std_msgs::Bool>("finished", 1, kLatched);
  finished_.publish(std_msgs::Bool());

  const auto grid = [&](const char* topic, nav_msgs::OccupancyGrid::ConstPtr& newest) {
    subscribers_.push_back(node.subscribe<nav_msgs::OccupancyGrid>(
        topic, 1, [this, topic, &newest](const nav_msgs::OccupancyGrid::ConstPtr& message) {
          takeGrid(newest, message, topic);
        }));
  };
  grid("map", map_.map);
  grid("map_probability", map_.probability);
  subscribers_.push_back(node.subscribe<structure_from_wifi::Walls>(
      "walls", 1,
      [this](const structure_from_wifi::Walls::ConstPtr& walls) { map_.walls = walls; }));
  subscribers_.push_back(node.subscribe<structure_from_wifi::AccessPoints>(
      "access_points", 1, [this](const structure_from_wifi::AccessPoints::ConstPtr& message) {
        map_.access_points = message;
      }));
  subscribers_.push_back(node.subscribe("contact", kQueue, &ExplorationNodelet::takeContact, this));
  subscribers_.push_back(
      node.subscribe("contact_points", kQueue, &ExplorationNodelet::takeContactPoints, this));

  using Trigger = std_srvs::Trigger;
  services_.push_back(own.advertiseService<Trigger::Request, Trigger::Response>(
      "start", [this](Trigger::Request& /*request*/, Trigger::Response& response) {
        return start(response);
      }));
  services_.push_back(own.advertiseService<Trigger::Request, Trigger::Response>(
      "stop", [this](Trigger::Request& /*request*/, Trigger::Response& response) {
        return stop(response);
      }));

  timer_ = node.createTimer(ros::Duration(kPeriod), [this](const ros::TimerEvent&) { tick(); });
  diagnostics_.emplace(getNodeHandle(), getPrivateNodeHandle(), getName());
  diagnostics_->setHardwareID("none");
  diagnostics_->add("exploration", [this](auto& status) { describe(status); });
  // Of real time, so that it also tells of a clock that stands still.
  diagnostics_timer_ = node.createWallTimer(
      ros::WallDuration(1.0), [this](const ros::WallTimerEvent&) { diagnostics_->force_update(); });
}

void ExplorationNodelet::takeGrid(nav_msgs::OccupancyGrid::ConstPtr& newest,
                                  const nav_msgs::OccupancyGrid::ConstPtr& message,
                                  const char* topic) {
  const std::string problem = problemOf(*message, settings_.map_frame);
  if (!problem.empty()) {
    NODELET_WARN_STREAM_THROTTLE(kWarningPeriod, "A grid on " << topic << " is ignored: " << problem
                                                              << ". Is the mapper its publisher?");
    return;
  }
  newest = message;
  new_map_ = true;
}

void ExplorationNodelet::takeContact(const std_msgs::Bool& contact) {
  contact_ = contact.data != 0;
}

void ExplorationNodelet::takeContactPoints(const sensor_msgs::PointCloud2::ConstPtr& cloud) {
  try {
    const double farthest = settings_.robot.robot_radius_m + kBumperReach;
    Eigen::Isometry3d to_base = Eigen::Isometry3d::Identity();
    if (cloud->header.frame_id != settings_.base_frame) {
      const geometry_msgs::Transform transform =
          transforms_->lookupTransform(settings_.base_frame, cloud->header.frame_id, ros::Time(0))
              .transform;
      const auto& at = transform.translation;
      const auto& turn = transform.rotation;
      to_base = Eigen::Translation3d(at.x, at.y, at.z) *
                Eigen::Quaterniond(turn.w, turn.x, turn.y, turn.z);
    }
    contact_point_.reset();
    for (const Eigen::Vector3d& point : nearPoints(*cloud, farthest)) {
      const Position at = (to_base * point).head<2>();
      if (!contact_point_ || at.norm() < contact_point_->norm()) {
        contact_point_ = at;
        contact_point_at_ = ros::Time::now();
      }
    }
  } catch (const std::exception& error) {
    NODELET_WARN_STREAM_THROTTLE(kWarningPeriod,
                                 "A cloud on contact_points is ignored: " << error.what());
  }
}

bool ExplorationNodelet::start(std_srvs::Trigger::Response& response) {
  response.success = static_cast<std::uint8_t>(!pilot_->finished());
  response.message = pilot_->finished()
                         ? "the exploration has ended: " + pilot_->explorer().ending()
                     : active_ ? "the robot explores already"
                               : "the robot explores";
  active_ = !pilot_->finished();
  return true;
}

bool ExplorationNodelet::stop(std_srvs::Trigger::Response& response) {
  active_ = false;
  pilot_->pause();
  drive(false);
  response.success = 1;
  response.message = "the robot stands; ~start goes on";
  return true;
}

std::optional<RobotPose> ExplorationNodelet::pose() {
  try {
    const geometry_msgs::TransformStamped transform =
        transforms_->lookupTransform(settings_.map_frame, settings_.base_frame, ros::Time(0));
    const auto& at = transform.transform;
    const double yaw = yawOf(at.rotation);
    if ((ros::Time::now() - transform.header.stamp).toSec() > kOldestPose) {
      waits_for_ = "a newer transform from " + settings_.base_frame + " to " + settings_.map_frame +
                   ": the last one is older than a second";
      return std::nullopt;
    }
    if (!std::isfinite(at.translation.x) || !std::isfinite(at.translation.y) ||
        !std::isfinite(yaw)) {
      waits_for_ = "a finite transform from " + settings_.base_frame + " to " + settings_.map_frame;
      return std::nullopt;
    }
    return RobotPose{{at.translation.x, at.translation.y}, yaw};
  } catch (const tf2::TransformException& error) {
    waits_for_ = std::string("the robot's pose in tf: ") + error.what();
    return std::nullopt;
  }
}

std::optional<Position> ExplorationNodelet::touchedPoint(const RobotPose& pose) const {
  std::optional<Position> point;
  if (contact_point_ && (ros::Time::now() - contact_point_at_).toSec() < kPressed) {
    point = contact_point_;
  } else if (contact_) {
    point = Position(settings_.robot.robot_radius_m, 0.0);
  }
  if (point) {
    point = pose.position + Eigen::Rotation2Dd(pose.yaw_rad) * *point;
  }
  return point;
}

void ExplorationNodelet::tick() {
  try {
    step();
  } catch (const std::exception& error) {
    // The robot must not go on while nobody decides.
    waits_for_ = std::string("a map and a pose that fit together: ") + error.what();
    NODELET_ERROR_STREAM_THROTTLE(kWarningPeriod, "The exploration waits for " << waits_for_);
    pilot_->pause();
    drive(false);
  }
}

void ExplorationNodelet::step() {
  waits_for_.clear();
  const std::optional<RobotPose> at = pose();
  if (new_map_) {
    if (const auto view = viewOf(map_)) {
      pilot_->setMap(*view);
      if (move_base_) {
        move_base_->setMap(view->states.geometry.box());
      }
      new_map_ = false;
    }
  }
  if (!active_) {
    return;
  }
  if (!at) {
    pilot_->pause();  // move_base must not drive on either
    drive(false);
    return;
  }
  if (!pilot_->explorer().hasMap()) {
    waits_for_ = "a map: the topics map and map_probability of the mapper";
  } else if (move_base_ && !move_base_->connected()) {
    waits_for_ = "the action move_base; start it, or set driver to bumpers";
  }
  if (!waits_for_.empty()) {
    drive(false);
    return;
  }
  pilot_->step(*at, touchedPoint(*at), ros::Time::now().toSec());
  drive(!pilot_->finished());
  announce();
}

void ExplorationNodelet::drive(bool moving) {
  if (move_base_ && !move_base_->backsOff() && !commanding_) {
    return;  // move_base publishes commands itself
  }
  geometry_msgs::Twist twist;
  if (moving) {
    const DriveCommand& command = move_base_ ? move_base_->command() : way_driver_->command();
    twist.linear.x = command.speed_m_s;
    twist.angular.z = command.yaw_rate_rad_s;
  }
  const bool commands = twist.linear.x != 0.0 || twist.angular.z != 0.0;
  if (commands || commanding_) {
    commands_.publish(twist);
  }
  commanding_ = commands;
}

void ExplorationNodelet::announce() {
  const Explorer& explorer = pilot_->explorer();
  const std::string goal = pilot_->goal() ? pilot_->goal()->reason() : "";
  if (goal != announced_goal_) {
    announced_goal_ = goal;
    std_msgs::Header header;
    header.frame_id = settings_.map_frame;
    header.stamp = ros::Time::now();
    markers_.publish(toMarkers(explorer.goals(), pilot_->goal(), header));
    if (pilot_->goal()) {
      NODELET_DEBUG_STREAM("The next goal is (" << pilot_->goal()->position.transpose()
                                                << "): " << goal);
    }
  }
  if (pilot_->finished() && !announced_end_) {
    announced_end_ = true;
    std_msgs::Bool finished;
    finished.data = 1;
    finished_.publish(finished);
    if (pilot_->stuck()) {
      NODELET_ERROR(
          "The robot is stuck: nothing that it tried made it move. Free it by hand, then "
          "start the node again.");
    } else {
      NODELET_INFO_STREAM("The exploration has ended: " << explorer.ending() << ". The robot drove "
                                                        << std::lround(explorer.driven())
                                                        << " m and touched something "
                                                        << explorer.touches().size() << " times.");
    }
  }
}

void ExplorationNodelet::describe(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  using diagnostic_msgs::DiagnosticStatus;
  const Explorer& explorer = pilot_->explorer();
  if (pilot_->stuck()) {
    status.summary(DiagnosticStatus::ERROR, "The robot is stuck. Free it by hand.");
  } else if (pilot_->finished()) {
    status.summary(DiagnosticStatus::OK, "The exploration has ended: " + explorer.ending() + ".");
  } else if (!active_) {
    status.summary(DiagnosticStatus::OK, "The exploration stands; ~start starts it.");
  } else if (!waits_for_.empty()) {
    status.summary(DiagnosticStatus::WARN, "The exploration waits for " + waits_for_ + ".");
  } else if (explorer.phase() == Explorer::Phase::kReturning) {
    status.summary(DiagnosticStatus::OK, "The robot returns: " + explorer.ending() + ".");
  } else {
    status.summary(DiagnosticStatus::OK, "The robot explores.");
  }
  status.add("driver", settings_.driver);
  status.add("driven [m]", std::lround(explorer.driven()));
  status.add("touches", explorer.touches().size());
  status.add("goal", pilot_->goal() ? pilot_->goal()->reason() : std::string("none"));
}

}  // namespace sfw

PLUGINLIB_EXPORT_CLASS(sfw::ExplorationNodelet, nodelet::Nodelet)
