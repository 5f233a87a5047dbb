#pragma once

#include <string>
#include <vector>

#include "structure_from_wifi/mapper.h"

namespace sfw {

/// What a user should know of a map, a sentence each: that a drive was too short or too straight to
/// tell of walls, that signals tell nothing, that poses look as if they drifted. Empty if all is
/// well.
std::vector<std::string> mapNotes(const Snapshot& snapshot);

}  // namespace sfw
