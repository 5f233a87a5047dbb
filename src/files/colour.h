#pragma once

#include <array>

namespace sfw {

/// Red, green and blue in [0, 1].
using Colour = std::array<double, 3>;

}  // namespace sfw
