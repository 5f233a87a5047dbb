#pragma once

#include <cstddef>

#include "ros/mapping/localization.h"
#include "structure_from_wifi/mapper.h"
#include "structure_from_wifi/path_correction.h"

namespace sfw {

/// Inserts an observation into a mapper. The corrector gets its correction if the mapper keeps it.
/// @return the number of readings that the mapper keeps
std::size_t insert(const LocatedObservation& observation, Mapper& mapper, PathCorrector& corrector);

}  // namespace sfw
