#pragma once

namespace sfw {

/// Half a turn [rad].
constexpr double kPi = 3.14159265358979323846;

}  // namespace sfw
