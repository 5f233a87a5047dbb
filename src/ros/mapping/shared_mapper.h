#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ros/mapping/localization.h"
#include "ros/mapping/session.h"
#include "structure_from_wifi/config.h"
#include "structure_from_wifi/mapper.h"
#include "structure_from_wifi/path_correction.h"

namespace sfw {

/// A mapper for two threads: one inserts readings while the other infers a map from a copy.
///
/// A lock is held to insert and to copy (100 000 readings: 1 ms), never while readings are
/// corrected or a map is inferred. Thread-safe.
class SharedMapper {
 public:
  /// @param tolerance  larger jumps of the odometry frame move what was inserted before
  /// @throw InputError as Mapper
  SharedMapper(const Config& config, const std::vector<AccessPoint>& access_points,
               const PathCorrector::Tolerance& tolerance);

  /// @return the number of its readings that are kept
  std::size_t insert(const LocatedObservation& observation);

  /// Forgets all readings and corrections; the geometry stays.
  void reset();

  /// Changes the settings of later maps, except for the group `map`.
  /// @throw InputError as Mapper, and changes nothing
  void configure(const Config& config);

  /// Counts readings that were rejected before insertion (Mapper::recordRejected).
  void recordRejected(const std::string& reason, std::size_t count);

  /// Tells what is wrong with transforms (Mapper::recordFrames).
  void recordFrames(const FrameFinding& frames);

  /// The readings and contacts that no map uses.
  Rejections rejections() const;

  /// The number of readings kept, repeated ones too.
  std::size_t readings() const;

  /// A copy of the mapper, to infer from.
  struct Copy {
    Mapper mapper;
    std::uint64_t resets = 0;   ///< before the copy; with fewer than resets() it is out of date
    bool is_corrected = false;  ///< the correction moved something
  };

  /// Copies the mapper, and corrects the copy by all corrections so far.
  /// @param latest  tf's latest correction of each robot, which may have no reading yet
  Copy corrected(const std::vector<OdometryCorrection>& latest);

  /// Makes later maps cover the extent of a map of a corrected copy, so that they do not shrink
  /// when the correction changes. A copy that is out of date changes nothing.
  void keepExtent(const Box& extent, const Copy& copy);

  std::uint64_t resets() const;

  /// Adds a session of before: its readings, contacts, and access points that the table lacks.
  /// @return the number of access points whose position differs from the one that is kept
  /// @throw InputError naming the reason, and changes nothing, if the mapper refuses any of it.
  std::size_t add(const Session& session);

  /// Gives an access point a position. The table gets an access point that it lacks.
  /// @throw InputError if no map can hold the position
  void place(const Bssid& bssid, const Position& position);

  /// Forgets the readings and contacts of a region of the corrected map.
  /// @return the number of readings and of contacts
  std::pair<std::size_t, std::size_t> forget(const std::function<bool(const Position&)>& region);

 private:
  mutable std::mutex mutex_;
  Mapper mapper_;  // with all positions as tf first gave them
  PathCorrector corrector_;
  std::uint64_t resets_ = 0;
  std::size_t readings_ = 0;
};

}  // namespace sfw
