// Map updates of the mapping nodelet, all in the mapping thread.

#include <ctime>

#include "ros/mapping/mapping_nodelet.h"

namespace sfw {
namespace {

/// The CPU time of this thread so far [s].
double threadCpuSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  constexpr double kNano = 1e-9;
  return static_cast<double>(time.tv_sec) + kNano * static_cast<double>(time.tv_nsec);
}

}  // namespace

void MappingNodelet::publishWhatIsDue() {
  publishers_->publishDueMap();
  publishers_->publishDueOctomaps();
}

void MappingNodelet::updateMap() {
  const ros::SteadyTime now = ros::SteadyTime::now();
  const double period_s =
      updatePeriod(ros_settings_.publish_rate_hz, ros_settings_.cpu_share, last_update_cpu_s_);
  if ((now - last_update_).toSec() < period_s || !isUpdateDue()) {
    return;
  }
  last_update_ = now;
  const double start_s = threadCpuSeconds();
  publishMap(Checks::kChanged);
  last_update_cpu_s_ = threadCpuSeconds() - start_s;
}

bool MappingNodelet::isUpdateDue() {
  if (changed_ || hasJumped(robots_->latestCorrections(*transforms_))) {
    updates_without_news_ = 0;
    return true;
  }
  // Readings that are no news still come while the robot stands, so the cache may never be done.
  return refresh_cache_.isUnfinished() &&
         updates_without_news_++ < config_.tomography.ensemble_size;
}

std::shared_ptr<const Snapshot> MappingNodelet::refreshed(const SharedMapper::Copy& copy,
                                                          bool has_jumped) {
  if (has_jumped || copy.resets != refresh_resets_) {
    refresh_cache_.clear();
    refresh_resets_ = copy.resets;
  }
  return copy.mapper.refresh(refresh_cache_, stop_);
}

bool MappingNodelet::hasJumped(const std::vector<OdometryCorrection>& latest) const {
  for (const OdometryCorrection& now : latest) {
    for (const OdometryCorrection& before : last_map_corrections_) {
      if (before.robot == now.robot &&
          PathCorrector::isJump(before, now, jumpTolerance(ros_settings_))) {
        return true;
      }
    }
  }
  return false;
}

MappingNodelet::Mapping MappingNodelet::publishMap(Checks checks) {
  changed_ = false;  // before the copy: later readings are for the next map
  try {
    return makeMap(checks);
  } catch (...) {
    changed_ = true;
    throw;
  }
}

MappingNodelet::Mapping MappingNodelet::makeMap(Checks checks) {
  const std::vector<OdometryCorrection> latest = robots_->latestCorrections(*transforms_);
  const bool has_jumped = hasJumped(latest);
  last_map_corrections_ = latest;
  const ros::SteadyTime start = ros::SteadyTime::now();
  Mapping mapping{mapper_->corrected(last_map_corrections_), nullptr, {}};
  mapping.snapshot = checks == Checks::kAll ? mapping.copy.mapper.infer(stop_)
                                            : refreshed(mapping.copy, has_jumped);
  if (!mapping.snapshot) {
    return mapping;
  }
  mapper_->keepExtent(mapping.snapshot->extent, mapping.copy);
  mapping.findings = checks == Checks::kAll ? checker_.checkAll(*mapping.snapshot, stop_)
                                            : checker_.checkChanged(*mapping.snapshot, stop_);
  if (mapping.findings.unfinished) {
    changed_ = true;  // the next refresh checks the others, even without another reading
  }
  if (stop_) {
    mapping.snapshot = nullptr;
  }
  const double inference_s = (ros::SteadyTime::now() - start).toSec();
  const std::lock_guard<std::mutex> lock(publishing_);
  if (mapping.snapshot && mapping.copy.resets == mapper_->resets()) {
    publishers_->publish(mapping.snapshot, mapping.findings);
    announceMap(*publishers_->last());
    if (localisation_) {
      localisation_->learnFrom(mapping.copy.mapper);
    }
    if (checks == Checks::kChanged) {  // saving a map logs the complete list
      reportFaults(mapNotes(*mapping.snapshot, mapping.findings));
    }
  }
  noteUpdate(inference_s);
  return mapping;
}

void MappingNodelet::reportFaults(const std::vector<MapNote>& notes) {
  if (clear_reported_.exchange(false)) {
    reported_faults_.clear();
  }
  for (const MapNote& note : notes) {
    if (isFault(note) && reported_faults_.emplace(note.kind, note.about).second) {
      NODELET_WARN_STREAM(note.text);
    }
  }
}

void MappingNodelet::noteUpdate(double inference_s) {
  const std::lock_guard<std::mutex> lock(facts_mutex_);
  facts_.inference_s = inference_s;
  facts_.update_failure.clear();
  for (const std::vector<Step>* steps : {&kLocatingSteps, &kMappingSteps}) {
    for (const Step& step : *steps) {
      announcements_.forget(step.failure);
    }
  }
}

}  // namespace sfw
