#pragma once

#if __cplusplus < 201703L
#error "structure_from_wifi needs C++17. Link ${catkin_LIBRARIES} or structure_from_wifi::mapping."
#endif

/// Makes a function or class part of the shared library. The library hides every other symbol.
#define SFW_EXPORT __attribute__((visibility("default")))
