#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "structure_from_wifi/config.h"
#include "structure_from_wifi/export.h"
#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/path_correction.h"
#include "structure_from_wifi/recording_findings.h"
#include "structure_from_wifi/snapshot.h"
#include "structure_from_wifi/types.h"

namespace sfw {

class MapMethod;
class ReadingStore;
struct KeptFeatures;
enum class UseRadio;

/// What a live map keeps from one refresh to the next (Mapper::refresh). Not thread-safe.
class SFW_EXPORT RefreshCache {
 public:
  /// Keeps nothing yet.
  RefreshCache();
  /// Moves what is kept.
  /// @{
  RefreshCache(RefreshCache&& other) noexcept;
  RefreshCache& operator=(RefreshCache&& other) noexcept;
  /// @}
  ~RefreshCache();

  /// Whether the last map may differ from that of Mapper::infer. Then refresh again soon, with new
  /// readings or without.
  bool isUnfinished() const;

  /// Forgets everything. Do so after a change of many positions at once.
  void clear();

 private:
  friend class Mapper;

  std::shared_ptr<const MapMethod> method_;  // of the last refresh
  std::unique_ptr<KeptFeatures> kept_;
};

/// Collects readings and infers a map from all of them at once.
///
/// The map is a function of the set of readings: order of arrival, repetition of a scan and the
/// play rate of a bag do not matter. Of several readings of one radio at one stamp, the strongest
/// counts. Each robot has a path of its own, and no way joins two of them. Positions are rounded to
/// 0.1 mm and signals to 0.01 dB on insertion, so rounding errors of the poses do not matter
/// either. Copies share the immutable parts. Not thread-safe; its owner serialises calls.
class SFW_EXPORT Mapper {
 public:
  /// @param access_points  the table; if it is empty, each BSSID that is heard joins it (2000 at
  /// most),
  ///                       and its position is estimated
  /// @throw InputError if the configuration or the table of access points cannot be used.
  Mapper(const Config& config, const std::vector<AccessPoint>& access_points);
  /// Copies or moves readings and settings.
  /// @{
  Mapper(const Mapper& other);
  Mapper(Mapper&& other) noexcept;
  Mapper& operator=(const Mapper& other);
  Mapper& operator=(Mapper&& other) noexcept;
  /// @}
  ~Mapper();

  /// Makes room for so many readings at once. Without it, the mapper takes up to twice their memory
  /// while it grows.
  void reserve(std::size_t readings);

  /// Adds a reading or a contact. Any result but kAccepted and kUnknownAccessPoint leaves the map
  /// as it was. The cost is O(log access points). It is O(readings log readings) for the first
  /// position that seems too far away after positions that did not.
  /// @{
  InsertResult insert(const Reading& reading);
  InsertResult insert(const Contact& contact);
  /// @}

  /// Adds a pose of the path between readings.
  ///
  /// A pose counts where it lies between two readings in time, and 0.1 m from them and from the
  /// poses kept before it. So it fills the gaps of a slow scanner, and readings that are dense give
  /// the same map without poses. The cost is that of insert(). A pose that is rejected is not
  /// counted. Only the readings of the same robot count as those before and after it.
  InsertResult insertPose(std::int64_t stamp_ns, const Position& antenna_in_map,
                          const std::string& robot = {});

  /// Counts readings that were rejected before insertion, for the report.
  /// @param reason  in words
  /// @param count   number of readings
  void recordRejected(const std::string& reason, std::size_t count);

  /// Tells what is wrong with transforms, for the notes. It replaces what was told before.
  void recordFrames(const FrameFinding& frames);

  /// Moves readings, contacts and poses by the correction of a localisation. A reading or contact
  /// is dropped and counted if its new position does not fit the map. O(readings log corrections).
  void correct(const PathCorrection& correction);

  /// Moves them by a function of stamp [ns], position [m] and robot to the new position, likewise.
  void correct(
      const std::function<Position(std::int64_t, const Position&, const std::string&)>& moved);

  /// The extent of access points, path, contacts and the boxes of growTo() [m], without the map's
  /// margin. O(readings log readings), as for all functions below.
  Box extent() const;

  /// Makes the map cover a box from now on. A box that is too large changes nothing.
  void growTo(const Box& extent);

  /// Forgets readings, path and contacts; the geometry stays.
  void reset();

  /// Forgets every reading, contact and pose for which a test of its stamp [ns], position [m] and
  /// robot is true. The geometry stays. O(readings log readings).
  /// @return the number of readings and of contacts
  std::pair<std::size_t, std::size_t> forget(
      const std::function<bool(std::int64_t, const Position&, const std::string&)>& test);

  /// The table of access points.
  const std::vector<AccessPoint>& accessPoints() const;

  /// Replaces the table of access points; all readings stay.
  /// @throw InputError as the constructor, and changes nothing then.
  void setAccessPoints(const std::vector<AccessPoint>& access_points);

  /// The grid of the next snapshot. It grows in steps, and shrinks only when poses turn out to be
  /// stray.
  GridGeometry geometry() const;

  /// Every reading once, by stamp, bssid and robot. A file of these readings gives the same map
  /// again.
  std::vector<Reading> readings() const;

  /// Every contact, in order of arrival.
  const std::vector<Contact>& contacts() const;

  /// The poses of insertPose, by robot and stamp. With them, files give the same map again.
  std::vector<PathPose> poses() const;

  /// The readings and contacts that no map uses.
  const Rejections& rejections() const;

  /// Infers the map of all readings so far.
  /// @param stop  polled while inferring; nullptr is returned once it is true
  /// @{
  std::shared_ptr<const Snapshot> infer(const std::atomic<bool>& stop) const;
  std::shared_ptr<const Snapshot> infer() const;
  /// @}

  /// Infers the map of all readings so far for a robot that drives on. It takes half of the time
  /// of infer() or less, because most of the wall field stays that of earlier refreshes
  /// (doc/method/walls.md). 8 refreshes in a row without new readings give the map of infer(), or
  /// as many as tomography/ensemble_size.
  /// @param cache  of the refresh before
  /// @param stop   as of infer()
  std::shared_ptr<const Snapshot> refresh(RefreshCache& cache, const std::atomic<bool>& stop) const;

  /// Infers the same map as infer(), and forgets the readings, the path and the contacts on the
  /// way. This takes less memory.
  std::shared_ptr<const Snapshot> inferLast(const std::atomic<bool>& stop);

  /// Infers the map without any signal strength. This ablation shows the contribution of the radio.
  std::shared_ptr<const Snapshot> inferWithoutRadio() const;

  /// Changes the settings of later maps; those of the group `map` stay, as the readings lie on it.
  /// @throw InputError if they cannot be used; then nothing changes.
  void configure(const Config& config);

 private:
  struct Checked;
  std::shared_ptr<const Snapshot> mapOf(Checked data, UseRadio use_radio,
                                        const std::atomic<bool>& stop, KeptFeatures* kept) const;

  Config config_;
  std::shared_ptr<const MapMethod> method_;
  std::unique_ptr<ReadingStore> store_;
};

}  // namespace sfw
