#include "structure_from_wifi/data_checks.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "access_points/access_point_estimation.h"
#include "checks/recording_checks.h"
#include "radio/drift.h"

namespace sfw {
namespace {

constexpr double kMuchMore = 0.1;  // of the readings
constexpr double kMoved = 0.1;     // [m]
constexpr std::size_t kMostAtOnce = 4;

/// Looks for drift, unless another fault of the recording explains why signals of a place differ.
std::optional<DriftFinding> driftOf(const Snapshot& snapshot) {
  const RecordingFindings& recording = snapshot.recording;
  if (arePosesWrong(recording) || recording.signal_unit || !recording.sentinels.empty() ||
      recording.cached || recording.bursts) {
    return std::nullopt;
  }
  std::vector<std::vector<Sample>> samples;
  for (const AccessPointSummary& summary : snapshot.access_points) {
    samples.push_back(summary.samples);
  }
  if (const std::optional<DriftCheck> check = checkDrift(samples)) {
    return DriftFinding{check->ratio, check->returns, check->suspect};
  }
  return std::nullopt;
}

}  // namespace

DataFindings DataChecker::checkAll(const Snapshot& snapshot) {
  const std::atomic<bool> never{false};
  return checkAll(snapshot, never);
}

DataFindings DataChecker::checkAll(const Snapshot& snapshot, const std::atomic<bool>& stop) {
  checked_.assign(snapshot.access_points.size(), {});
  for (std::size_t i = 0; i < checked_.size() && !stop; ++i) {
    checked_[i] = check(snapshot.access_points[i]);
  }
  DataFindings all = findings();
  all.drift = stop ? std::nullopt : driftOf(snapshot);
  return all;
}

DataFindings DataChecker::checkChanged(const Snapshot& snapshot, const std::atomic<bool>& stop) {
  checked_.resize(snapshot.access_points.size());
  ++round_;
  // Among access points with equal change, the one with the oldest check comes first. Otherwise
  // repeated corrections of the path would always select the first ones of the table.
  std::vector<std::tuple<double, std::size_t, std::size_t>> due;
  for (std::size_t i = 0; i < checked_.size(); ++i) {
    const AccessPointSummary& summary = snapshot.access_points[i];
    const double change = changeOf(checked_[i], summary.samples);
    if (change >= kMuchMore && summary.access_point.position_known) {
      due.emplace_back(-change, checked_[i].round, i);
    }
  }
  std::sort(due.begin(), due.end());
  const std::size_t now = std::min(due.size(), kMostAtOnce);
  for (std::size_t j = 0; j < now && !stop; ++j) {
    const std::size_t i = std::get<2>(due[j]);
    checked_[i] = check(snapshot.access_points[i]);
    checked_[i].round = round_;
  }
  DataFindings changed = findings();
  changed.unfinished = due.size() > now;
  return changed;
}

/// The number of new readings over the number at the last check. It is infinite if the old readings
/// were replaced.
double DataChecker::changeOf(const Checked& checked, const std::vector<Sample>& samples) {
  constexpr double kAll = std::numeric_limits<double>::infinity();
  if (checked.readings == 0) {
    return samples.empty() ? 0.0 : kAll;
  }
  if (samples.size() < checked.readings ||
      (samples[checked.readings - 1].antenna_in_map - checked.last_position).norm() > kMoved) {
    return kAll;
  }
  return static_cast<double>(samples.size()) / static_cast<double>(checked.readings) - 1.0;
}

DataChecker::Checked DataChecker::check(const AccessPointSummary& summary) {
  Checked checked;
  checked.readings = summary.samples.size();
  if (!summary.samples.empty()) {
    checked.last_position = summary.samples.back().antenna_in_map;
  }
  const AccessPoint& access_point = summary.access_point;
  if (access_point.position_known) {
    checked.fit =
        accessPointFit(summary.samples, summary.given_position.value_or(access_point.position),
                       access_point.height_m, access_point.position_sd_m);
  }
  return checked;
}

DataFindings DataChecker::findings() const {
  DataFindings all;
  for (const Checked& checked : checked_) {
    all.fits.push_back(checked.fit);
  }
  return all;
}

}  // namespace sfw
