#include "structure_from_wifi/data_checks.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace sfw {
namespace {

constexpr double kMuchMore = 0.1;  // of the readings
constexpr double kMoved = 0.1;     // [m]
constexpr std::size_t kMostAtOnce = 4;

}  // namespace

void DataChecker::checkAll(const Mapper& mapper, Snapshot& snapshot,
                           const std::atomic<bool>& stop) {
  const std::vector<std::vector<Sample>> samples = mapper.samples();
  known_.assign(samples.size(), {});
  for (std::size_t i = 0; i < samples.size() && !stop; ++i) {
    judge(snapshot.access_points[i].access_point, samples[i], known_[i]);
  }
  note(snapshot);
  if (!stop) {
    snapshot.drift = checkDrift(samples);
  }
}

void DataChecker::checkAll(const Mapper& mapper, Snapshot& snapshot) {
  const std::atomic<bool> never{false};
  checkAll(mapper, snapshot, never);
}

bool DataChecker::checkChanged(const Mapper& mapper, Snapshot& snapshot,
                               const std::atomic<bool>& stop) {
  const std::vector<std::vector<Sample>> samples = mapper.samples();
  known_.resize(samples.size());
  ++round_;
  // Of those that changed as much, whoever waits longest comes first: a path that is corrected
  // again and again would else have the first of the table judged for ever.
  std::vector<std::tuple<double, std::size_t, std::size_t>> due;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double much = change(known_[i], samples[i]);
    if (much >= kMuchMore && snapshot.access_points[i].access_point.position_known) {
      due.emplace_back(-much, known_[i].round, i);
    }
  }
  std::sort(due.begin(), due.end());
  const std::size_t now = std::min(due.size(), kMostAtOnce);
  for (std::size_t j = 0; j < now && !stop; ++j) {
    const std::size_t i = std::get<2>(due[j]);
    judge(snapshot.access_points[i].access_point, samples[i], known_[i]);
    known_[i].round = round_;
  }
  note(snapshot);
  return due.size() > now;
}

/// Share of readings more than at the last judgement; infinite if they are others.
double DataChecker::change(const Known& known, const std::vector<Sample>& samples) {
  constexpr double kAll = std::numeric_limits<double>::infinity();
  if (known.readings == 0) {
    return samples.empty() ? 0.0 : kAll;
  }
  if (samples.size() < known.readings ||
      (samples[known.readings - 1].antenna_in_map - known.last_place).norm() > kMoved) {
    return kAll;
  }
  return static_cast<double>(samples.size()) / static_cast<double>(known.readings) - 1.0;
}

void DataChecker::judge(const AccessPoint& access_point, const std::vector<Sample>& samples,
                        Known& known) {
  known = {};
  known.readings = samples.size();
  if (!samples.empty()) {
    known.last_place = samples.back().antenna_in_map;
  }
  if (access_point.position_known) {
    known.fit = accessPointFit(samples, access_point.position, access_point.height_m);
  }
}

void DataChecker::note(Snapshot& snapshot) const {
  for (std::size_t i = 0; i < known_.size(); ++i) {
    snapshot.access_points[i].fit = known_[i].fit;
  }
}

}  // namespace sfw
