#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "base/reading_refs.h"
#include "structure_from_wifi/snapshot.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// The readings of one access point: robot by robot, in the order of stamps.
struct AccessPointReadings {
  std::vector<Sample> samples;
  std::vector<std::uint32_t> poses;  ///< index of each sample's pose in the path
};

/// The data of a map: all inserted data without stray poses and repeated readings.
struct Inliers {
  std::vector<PathPose> path;                 ///< every pose once, as sortedPath orders them
  std::vector<AccessPointReadings> readings;  ///< by access point, in the order of the table
  std::vector<Contact> contacts;
  StrayPoses stray = {};
  PathMotion motion = {};
  std::size_t stamped_alike = 0;  ///< as Snapshot::stamped_alike
};

/// Inliers whose samples wait in the readings that they come from: robot by robot, by stamp.
struct InlierReadings {
  Inliers inliers;  ///< with an empty list `readings`
  ReadingRefs used;
};

/// Removes the readings and contacts at stray poses, and all but the strongest reading of each
/// radio at each stamp. Each robot has a path of its own.
/// @param sorted    all readings, as sortedByStamp returns them
/// @param poses     of the path between readings, in any order; posesBetween selects from them
/// O(n log n) for n readings and poses.
InlierReadings readingsWithoutStrayPoses(const ReadingRefs& sorted, std::vector<Contact> contacts,
                                         const std::vector<PathPose>& poses);

/// Makes the samples of each access point.
/// @param index_of  the index of each access point in the table; readings of others only add poses
Inliers withSamples(InlierReadings readings, const std::map<Bssid, std::size_t>& index_of);

/// Both in one: the data of a map.
Inliers withoutStrayPoses(const ReadingRefs& sorted, std::vector<Contact> contacts,
                          const std::map<Bssid, std::size_t>& index_of,
                          const std::vector<PathPose>& poses = {});

/// Removes the contacts over which the robot drove later: nothing stands there any more.
/// @param path       in the order driven
/// @param within_m   distance of the antenna to a contact that it drives over
/// @param max_gap_m  longer steps of the path were not driven straight
/// O(contacts x poses).
void removeDrivenOver(const std::vector<PathPose>& path, double within_m, double max_gap_m,
                      std::vector<Contact>& contacts);

/// Removes the readings whose value stands for "not heard". Their poses stay in the path.
/// @param readings  of each access point of the table
void removeSentinels(const std::vector<SentinelFinding>& sentinels,
                     const std::vector<AccessPoint>& table,
                     std::vector<AccessPointReadings>& readings);

/// Removes the readings that repeat the one before it of their radio while the robot drives, as a
/// driver with a cache of scans reports them. The first one stays, at the place where it was heard.
void removeRepeated(std::vector<AccessPointReadings>& readings);

/// The antenna positions of a path [m], map frame, in its order.
///
/// The paths of two robots follow one another, and what reads positions joins those that are near.
/// So a position of the path that is farther than `max_gap_m` from both ends stands between them,
/// a second time. An area so small that it has no such position is driven anyway.
std::vector<Position> positionsOf(const std::vector<PathPose>& path, double max_gap_m);

/// Sorts readings by stamp, bssid and robot, the strongest first where all are equal.
/// The result refers to them.
ReadingRefs sortedByStamp(const std::vector<Reading>& readings);

/// Keeps the first reading of each radio by each robot at each stamp.
/// @param sorted  as sortedByStamp returns them
std::vector<Reading> strongestOfEachStamp(const ReadingRefs& sorted);

}  // namespace sfw
