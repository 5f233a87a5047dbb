#pragma once

#include <vector>

#include "structure_from_wifi/map_notes.h"
#include "structure_from_wifi/snapshot.h"

namespace sfw {

/// Adds notes on poses and their stamps: those of wrong stamps alone, or else all others.
void addNotesOnDrive(const Snapshot& snapshot, std::vector<MapNote>& notes);

/// Adds a note on readings that lie too far apart.
void addNoteOnGaps(const GapFinding& gaps, std::vector<MapNote>& notes);

/// Whether the path is long enough to say more of it than that it is short.
bool isDriven(const std::vector<PathPose>& path);

/// Whether the path lies along a line.
bool isStraight(const std::vector<PathPose>& path);

/// Whether the path jumps, or is faster than a robot.
bool isDoubtful(const PathMotion& motion);

}  // namespace sfw
