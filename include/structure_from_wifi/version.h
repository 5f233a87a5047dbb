#pragma once

namespace sfw {

/// The version of this library, as package.xml has it: "0.1.0".
const char* version();

}  // namespace sfw
