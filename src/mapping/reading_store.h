#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "checks/recording_data.h"
#include "mapping/inliers.h"
#include "mapping/map_extent.h"
#include "structure_from_wifi/config.h"
#include "structure_from_wifi/recording_findings.h"
#include "structure_from_wifi/snapshot.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Stores readings, contacts and the path between readings, and rejects those that a map cannot
/// use.
///
/// Mapper documents the functions of the same names. Not thread-safe.
class ReadingStore {
 public:
  /// @param access_points  empty: the table is open
  /// @throw InputError if the table of access points cannot be used.
  ReadingStore(const Config::Map& config, const std::vector<AccessPoint>& access_points);

  void reserve(std::size_t readings);
  InsertResult insert(const Reading& reading);
  InsertResult insert(const Contact& contact);
  InsertResult insertPose(std::int64_t stamp_ns, const Position& antenna_in_map,
                          const std::string& robot);
  void recordRejected(const std::string& reason, std::size_t count);
  void recordFrames(const FrameFinding& frames) { frames_ = frames; }
  void correct(
      const std::function<Position(std::int64_t, const Position&, const std::string&)>& moved);
  /// Frees the memory of the readings, the path and the contacts. Counts and geometry stay.
  void drop();
  void growTo(const Box& extent) { extent_.growTo(extent); }
  void reset();
  std::pair<std::size_t, std::size_t> forget(
      const std::function<bool(std::int64_t, const Position&, const std::string&)>& test);
  void setAccessPoints(std::vector<AccessPoint> access_points);

  const std::vector<AccessPoint>& accessPoints() const { return table_->access_points; }
  std::vector<Reading> readings() const;
  const std::vector<Contact>& contacts() const { return contacts_; }
  std::vector<PathPose> poses() const;
  const Rejections& rejections() const { return rejections_; }

  const FrameFinding& frames() const { return frames_; }

  /// Whether no table was given: each BSSID that is heard then joins it.
  bool isOpen() const { return is_open_; }

  /// The readings offered for each access point of the table, used or not.
  std::vector<std::size_t> heard() const;

  /// Everything offered, for the checks. It refers to readings of this store, and is valid until
  /// they change. O(readings log readings).
  RecordingData data() const;

  /// The data of a map. It refers to readings of this store, as data() does.
  /// @param sorted  all readings, as sortedByStamp returns them
  InlierReadings inliers(const ReadingRefs& sorted) const;

  /// The samples of each access point of the table.
  Inliers withSamples(InlierReadings readings) const;

  /// The extent of a map of such data [m], without its margin.
  Box extentOf(const Inliers& inliers) const;

  /// The extent of a map of all data [m], without its margin. O(readings log readings).
  Box extent() const { return extentOf(inliers(sortedByStamp(readings_)).inliers); }

  /// The grid of a map with such an extent.
  /// @throw InputError if it would have more than map/max_cells cells.
  GridGeometry geometryOf(const Box& extent) const { return extent_.geometryOf(extent); }

 private:
  /// Whether a BSSID is in the table. It joins an open one.
  bool isInTable(const Bssid& bssid);
  InsertResult examine(const Reading& reading) const;
  InsertResult accept(const Reading& reading);
  /// Keeps what the checks need of a reading that is offered.
  void remember(const Reading& reading, InsertResult result);

  InsertResult makeRoomFor(const Position& point);

  /// Extends the reserved extent to everything.
  /// @return false, and changes nothing, if the map would be too large.
  bool reserveAll();
  /// Drops the readings and contacts that do not fit the map, in order of arrival.
  void dropWhatDoesNotFit();

  struct Table {
    std::vector<AccessPoint> access_points;
    std::map<Bssid, std::size_t> index_of;
  };
  static std::shared_ptr<const Table> makeTable(const std::vector<AccessPoint>& access_points);

  Config::Map config_;
  MapExtent extent_;
  bool is_open_;
  std::shared_ptr<const Table> table_;  // never changes: copies share it
  std::vector<Reading> readings_;
  std::vector<Contact> contacts_;
  std::vector<PathPose> poses_;  // of the path between readings
  Rejections rejections_;

  std::vector<Reading> refused_;        // for their signal or position; the first ones
  std::map<Bssid, std::size_t> heard_;  // of the table
  std::map<std::string, std::int64_t> last_stamp_ns_;  // the latest one so far of each robot
  std::int64_t step_back_ns_ = 0;
  FrameFinding frames_;
};

}  // namespace sfw
