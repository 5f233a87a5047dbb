#pragma once

#include "structure_from_wifi/export.h"

namespace sfw {

/// The version of this library, as package.xml has it: "0.2.0".
SFW_EXPORT const char* version();

}  // namespace sfw
