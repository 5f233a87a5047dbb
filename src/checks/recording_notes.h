#pragma once

#include <vector>

#include "structure_from_wifi/map_notes.h"
#include "structure_from_wifi/recording_findings.h"

namespace sfw {

/// Adds notes on what the recording's own data show to be wrong, apart from access points.
void addNotesOnRecording(const RecordingFindings& recording, std::vector<MapNote>& notes);

}  // namespace sfw
