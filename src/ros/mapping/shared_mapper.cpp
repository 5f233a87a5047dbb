#include "ros/mapping/shared_mapper.h"

#include <utility>

#include "ros/mapping/insertion.h"

namespace sfw {

SharedMapper::SharedMapper(const Config& config, const std::vector<AccessPoint>& access_points,
                           const PathCorrector::Tolerance& tolerance)
    : mapper_(config, access_points), corrector_(tolerance) {}

void SharedMapper::insert(const LocatedObservation& observation) {
  const std::lock_guard<std::mutex> lock(mutex_);
  readings_ += sfw::insert(observation, mapper_, corrector_);
}

void SharedMapper::recordRejected(const std::string& reason, std::size_t count) {
  const std::lock_guard<std::mutex> lock(mutex_);
  mapper_.recordRejected(reason, count);
}

void SharedMapper::reset() {
  const std::lock_guard<std::mutex> lock(mutex_);
  mapper_.reset();
  corrector_.clear();
  readings_ = 0;
  ++resets_;
}

Rejections SharedMapper::rejections() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return mapper_.rejections();
}

std::size_t SharedMapper::readings() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return readings_;
}

std::uint64_t SharedMapper::resets() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return resets_;
}

SharedMapper::Copy SharedMapper::corrected(const std::optional<OdometryCorrection>& latest) {
  std::unique_lock<std::mutex> lock(mutex_);
  Copy copy{mapper_, resets_, false};
  PathCorrector corrector = corrector_;
  lock.unlock();
  // tf's latest correction is not stored. It depends on the time of this call, and later maps must
  // not.
  if (latest && corrector.size() > 0) {
    corrector.insert(*latest);
  }
  const PathCorrection correction = corrector.correction();
  copy.mapper.correct(correction);
  copy.is_corrected = !correction.empty();
  return copy;
}

void SharedMapper::keepExtent(const Box& extent, const Copy& copy) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (copy.is_corrected && copy.resets == resets_) {
    mapper_.growTo(extent);
  }
}

}  // namespace sfw
