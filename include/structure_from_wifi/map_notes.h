#pragma once

#include <string>
#include <vector>

#include "structure_from_wifi/export.h"
#include "structure_from_wifi/mapper.h"

namespace sfw {

/// What a user should know of a map, a sentence.
struct MapNote {
  enum class Kind {
    kTooLittle,  ///< driven or heard so far
    kStamps,
    kStrayPoses,
    kMotion,
    kSignals,
    kAccessPoint,
    kOctomap,
    kDrift,
  };
  Kind kind;
  std::string about;  ///< tells notes of one kind apart: an access point's bssid, say
  std::string text;
};

/// Whether a note is of something that is wrong, and not just of what is missing at the beginning
/// of each drive.
SFW_EXPORT bool isFault(const MapNote& note);

/// What is to be told of a map: that a drive was too short or too straight to tell of walls, that
/// signals tell nothing, that poses look as if they drifted. Empty if all is well.
SFW_EXPORT std::vector<MapNote> mapNotes(const Snapshot& snapshot);

}  // namespace sfw
