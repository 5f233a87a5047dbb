#pragma once

namespace sfw {

/// How many times longer a program takes with the sanitizer that it is built with. Limits of time
/// in tests grow by it.
#if defined(__SANITIZE_THREAD__)
constexpr double kSlowdown = 10.0;
#elif defined(__SANITIZE_ADDRESS__)
constexpr double kSlowdown = 3.0;
#else
constexpr double kSlowdown = 1.0;
#endif

}  // namespace sfw
