#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evaluation/evaluation.h"
#include "support/ascii_world.h"

namespace sfw::test {

using Rows = std::vector<std::string>;

/// The middle of a cell of 0.05 m.
inline Position at(double x, double y) { return {(x + 0.5) * 0.05, (y + 0.5) * 0.05}; }

inline std::vector<Position> along(double from_x, double to_x, double y) {
  std::vector<Position> path;
  for (double x = from_x; x <= to_x; x += 1.0) {
    path.push_back(at(x, y));
  }
  return path;
}

inline EvaluationInput input(const Rows& map, const Rows& truth,
                             const std::vector<Position>& path) {
  return {world(map), world(truth), path, {}, std::nullopt};
}

/// Two rooms. The path runs along the middle of the left one, whose 5 x 5 cells are the region;
/// its 24 walls are the left frame with the column x = 6, without the frame from x = 7 on.
inline const Rows kRooms = {"############",  //
                            "#.....#....#",  //
                            "#.....#....#",  //
                            "#.....#....#",  //
                            "#.....#....#",  //
                            "#.....#....#",  //
                            "############"};
/// A map that misses the column x = 1. It calls the wall x = 6 and a column behind it free, and its
/// far wall is two cells too far.
inline const Rows kMap = {"????????????",  //
                          "#?......#???",  //
                          "#?......#???",  //
                          "#?......#???",  //
                          "#?......#???",  //
                          "#?......#???",  //
                          "????????????"};

inline EvaluationInput rooms() { return input(kMap, kRooms, along(1, 5, 3)); }

}  // namespace sfw::test
