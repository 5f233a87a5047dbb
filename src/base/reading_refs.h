#pragma once

#include <functional>
#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// Readings that another list holds: copies of a million would take much memory. The other list
/// must live longer, and must not change.
using ReadingRefs = std::vector<std::reference_wrapper<const Reading>>;

}  // namespace sfw
