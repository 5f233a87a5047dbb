#pragma once

#include <vector>

#include "structure_from_wifi/data_checks.h"
#include "structure_from_wifi/map_notes.h"
#include "structure_from_wifi/snapshot.h"

namespace sfw {

/// Adds a note on access points of the table that are never heard. Each may simply be far away, so
/// the note names them.
void addNoteOnSilence(const Snapshot& snapshot, std::vector<MapNote>& notes);

/// Adds notes on access points without position, heard at one place, or of one radio.
void addNotesOnRadios(const Snapshot& snapshot, std::vector<MapNote>& notes);

/// Adds notes on positions of access points that contradict the readings or are uncertain.
void addNotesOnPositions(const Snapshot& snapshot, const DataFindings& findings,
                         std::vector<MapNote>& notes);

}  // namespace sfw
