#pragma once

namespace sfw {

constexpr double kPi = 3.14159265358979323846;

}  // namespace sfw
