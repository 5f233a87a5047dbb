// What the mapping nodelet tells on /diagnostics.

#include "ros/mapping/mapping_nodelet.h"

namespace sfw {

void MappingNodelet::advertiseDiagnostics() {
  using Wrapper = diagnostic_updater::DiagnosticStatusWrapper;
  diagnostics_.emplace(getNodeHandle(), getPrivateNodeHandle(),
                       getPrivateNodeHandle().getNamespace());
  diagnostics_->setHardwareID("none");
  diagnostics_->add("inputs", [this](Wrapper& to) { describeInputs(status_, to); });
  diagnostics_->add("transforms", [this](Wrapper& to) { describeTransforms(status_, to); });
  diagnostics_->add("map", [this](Wrapper& to) { describeMap(status_, to); });
}

void MappingNodelet::diagnose() {
  const ros::SteadyTime now = ros::SteadyTime::now();
  if (now < next_diagnosis_) {
    return;
  }
  next_diagnosis_ = now + ros::WallDuration(1.0);
  status_ = status();
  if (diagnostics_) {
    diagnostics_->force_update();  // update() would stop with the simulated clock
  }
  if (failure_.empty()) {
    subscribeAnew();
    mapper_->recordFrames(status_.frames);
    announceMissingInput();
    if (announcements_.isNews("infinite transforms", status_.infinite_transforms)) {
      NODELET_WARN_STREAM(status_.infinite_transforms
                          << " transforms on /tf are not finite and left out; look for the node "
                             "that publishes them");
    }
  }
}

TransformStatus MappingNodelet::transformStatusOfRobots() const {
  std::optional<TransformStatus> first;
  for (const RosSettings& robot : robots_->settings()) {
    TransformStatus status = transformStatus(robot, *transforms_, ros::Time::now());
    if (!status.tf_error.empty() || status.age_s > ros_settings_.transform_timeout_s) {
      return status;
    }
    first = first ? first : std::optional(std::move(status));
  }
  return *first;
}

FrameFinding MappingNodelet::frameFindingOfRobots() const {
  FrameFinding finding;
  for (const RosSettings& robot : robots_->settings()) {
    if (finding.published_twice.empty()) {
      finding = transform_watch_.finding(robot.antenna_frame);
    }
  }
  return finding;
}

MappingStatus MappingNodelet::status() const {
  MappingStatus status;
  const ros::SteadyTime now = ros::SteadyTime::now();
  status.now_s = now.toSec();
  status.running_s = (now - started_).toSec();
  status.failure = failure_;
  if (!failure_.empty()) {
    return status;
  }
  status.is_clock_missing = ros::Time::isSimTime() && ros::Time::now().isZero();
  status.inputs = statistics_.inputs(status.now_s);
  status.transform = transformStatusOfRobots();
  status.frames = frameFindingOfRobots();
  status.frames.floors_m = floors_.heights();
  status.infinite_transforms = transform_intake_ ? transform_intake_->leftOut() : 0;
  status.transform_timeout_s = ros_settings_.transform_timeout_s;
  status.is_paused = paused_;
  status.waiting = queue_->readings();
  status.readings = mapper_->readings();
  status.rejections = mapper_->rejections();
  if (const auto last = publishers_->last()) {
    status.map = last->snapshot;
    status.findings = last->findings;
    status.free_m2 = last->free_m2;
  }
  const std::lock_guard<std::mutex> lock(facts_mutex_);
  status.update_failure = facts_.update_failure;
  status.autosave_failure = facts_.autosave_failure;
  status.inference_s = facts_.inference_s;
  status.expired = facts_.expired;
  status.expired_contacts = facts_.expired_contacts;
  status.overflowed = facts_.overflowed;
  status.tilted = facts_.tilted;
  status.jumped = facts_.jumped;
  return status;
}

}  // namespace sfw
