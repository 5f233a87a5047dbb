#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "ros/mapping/observation_queue.h"
#include "structure_from_wifi/config.h"
#include "structure_from_wifi/mapper.h"
#include "structure_from_wifi/path_correction.h"

namespace sfw {

/// A mapper that takes readings while a map is inferred from those before.
///
/// Its lock is held to insert and to copy (100 000 readings: 1 ms), never while readings are moved
/// or a map is inferred. Thread-safe.
class SharedMapper {
 public:
  /// @throw InputError as Mapper
  SharedMapper(const Config& config, const std::vector<AccessPoint>& access_points);

  void insert(const PlacedObservation& observation);

  /// Forgets everything but the geometry.
  void reset();

  /// Notes readings that never got as far as to be placed (Mapper::recordRejected).
  void recordRejected(const std::string& reason, std::size_t count);

  /// What was left out, by reason.
  std::map<InsertResult, std::size_t> rejectionCounts() const;

  /// A copy to infer from, with everything where it belongs by the last that tf says.
  struct Copy {
    Mapper mapper;
    std::uint64_t resets = 0;   ///< before it was made: with fewer than resets() it is out of date
    bool is_corrected = false;  ///< the correction moved something
  };
  Copy corrected(const std::optional<OdometryCorrection>& latest);

  /// Makes later maps cover the extent of a map of a corrected copy, so that they do not shrink
  /// when the correction changes. A copy that is out of date changes nothing.
  void keepExtent(const Box& extent, const Copy& copy);

  std::uint64_t resets() const;

 private:
  mutable std::mutex mutex_;
  Mapper mapper_;  // everything where tf first saw it
  PathCorrector anchor_;
  std::uint64_t resets_ = 0;
};

}  // namespace sfw
