#include "structure_from_wifi/version.h"

namespace sfw {

const char* version() { return SFW_VERSION; }

}  // namespace sfw
