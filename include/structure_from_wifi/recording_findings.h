#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "structure_from_wifi/bssid.h"

namespace sfw {

/// A unit of x and y.
enum class LengthUnit { kMetres, kPixels, kCentimetres, kMillimetres };

/// A unit of stamps.
enum class TimeUnit { kSeconds, kMilliseconds, kMicroseconds, kMinutes, kDays };

/// Positions or stamps in other units than metres and seconds.
struct UnitFinding {
  LengthUnit length = LengthUnit::kMetres;  ///< in which x and y seem to be
  TimeUnit time = TimeUnit::kSeconds;       ///< in which stamps seem to be
  double usual_speed_m_s = 0.0;             ///< if they were in metres and seconds
  double extent_m = 0.0;                    ///< diagonal of the driven area, likewise
};

/// Signals that are no dBm.
struct SignalUnitFinding {
  enum class Scale {
    kPositive,      ///< percent, a quality, or dBm without their sign
    kPercent,       ///< a positive value that falls with distance
    kWithoutSign,   ///< a positive value that grows with distance
    kUnsignedByte,  ///< dBm + 256
    kTenths,        ///< dBm * 10
    kMilliDbm,      ///< dBm * 100, the mBm of nl80211
  };
  Scale scale = Scale::kPositive;
  std::size_t readings = 0;   ///< that are refused
  double lowest = 0.0;        ///< of their values
  double highest = 0.0;       ///< likewise
  std::vector<Bssid> radios;  ///< of the table
};

/// One value that stands for "not heard". The map does not use such readings.
struct SentinelFinding {
  double value_dbm = 0.0;
  std::size_t readings = 0;   ///< of that value
  std::vector<Bssid> radios;  ///< of the table, with such readings
};

/// Radios whose values stay the same while the robot drives, and then change by a lot.
struct CachedFinding {
  std::vector<Bssid> radios;  ///< of the table, the most constant one first
  double readings = 0.0;      ///< that repeat one value, on average
  double way_m = 0.0;         ///< that is driven meanwhile, on average
};

/// Poses in two places at the same time.
struct OverlapFinding {
  std::size_t times = 0;            ///< poses between two of the other place
  std::int64_t first_stamp_ns = 0;  ///< of the first one
  double farthest_m = 0.0;          ///< distance of the two places
  double step_back_s = 0.0;         ///< largest step back of the stamps in order of arrival
};

/// Readings in bursts, with long ways between them.
struct BurstFinding {
  double readings = 0.0;  ///< of a radio in a burst, on average
  double period_s = 0.0;  ///< median time between bursts
  double way_m = 0.0;     ///< median way between bursts
};

/// Steps of the path that are longer than path/max_gap.
struct GapFinding {
  std::size_t steps = 0;   ///< that are too long
  double share = 0.0;      ///< of the way
  double usual_m = 0.0;    ///< their median length
  double max_gap_m = 0.0;  ///< the setting
};

/// Radios that send several BSSIDs. A map takes each of them as one witness.
struct AliasFinding {
  std::vector<std::vector<Bssid>> groups;  ///< the BSSIDs of each such radio
};

/// What the ROS side finds in transforms. The mapper only passes it on to the notes.
struct FrameFinding {
  std::string missing;           ///< a frame that no transform has; empty: none
  std::size_t lost = 0;          ///< readings without position because of it
  std::string published_twice;   ///< a transform of two publishers, as "map to odom"; empty: none
  std::size_t flips = 0;         ///< of that transform, to and fro
  std::vector<double> floors_m;  ///< heights of the antenna, if it is on several floors
};

/// What the data of a recording show to be wrong with it (doc/method/checks.md). A member is empty
/// if its check finds nothing.
struct RecordingFindings {
  std::optional<UnitFinding> units = {};
  std::optional<SignalUnitFinding> signal_unit = {};
  std::vector<SentinelFinding> sentinels = {};
  std::optional<CachedFinding> cached = {};
  std::optional<OverlapFinding> overlap = {};
  std::optional<BurstFinding> bursts = {};
  std::optional<GapFinding> gaps = {};
  AliasFinding aliases = {};
  std::vector<Bssid> single_place = {};  ///< radios that are heard at one place only
  FrameFinding frames = {};
  bool is_one_stamp = false;    ///< all readings have the same stamp
  bool are_stamps_cut = false;  ///< so many stamps are equal that the path has gaps
};

}  // namespace sfw
