#pragma once

#include <string>
#include <vector>

#include "structure_from_wifi/data_checks.h"
#include "structure_from_wifi/export.h"
#include "structure_from_wifi/snapshot.h"

namespace sfw {

/// A sentence about a map for its user.
struct MapNote {
  /// The subject of a note.
  enum class Kind {
    kTooLittle,  ///< too few poses or readings so far
    kStamps,
    kStrayPoses,
    kMotion,
    kSignals,
    kAccessPoint,
    kOctomap,
    kDrift,
    kUnits,
    kFrames,
    kCoverage,
  };
  Kind kind;          ///< its subject
  std::string about;  ///< distinguishes notes of one kind
  std::string text;   ///< one or two sentences
};

/// Whether a note reports a fault. The other notes report missing data, which is normal at the
/// start of a drive.
SFW_EXPORT bool isFault(const MapNote& note);

/// Lists the weaknesses of a map: a drive too short or too straight, signals without information,
/// poses that seem to have drifted. The list is empty if there are none.
SFW_EXPORT std::vector<MapNote> mapNotes(const Snapshot& snapshot,
                                         const DataFindings& findings = {});

}  // namespace sfw
