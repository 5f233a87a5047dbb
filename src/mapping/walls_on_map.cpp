#include "mapping/walls_on_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "grid/ray.h"

namespace sfw {
namespace {

constexpr double kBesideDoor = 0.15;  // [m], between a wall's end and the way of the robot

/// A cell on the line of a wall.
struct LineCell {
  Cell cell;
  bool is_wall;  ///< false beyond the ends of the wall
};

/// The line of a wall on the map, which goes on straight beyond both ends for kBesideDoor.
std::vector<LineCell> lineOnMap(const StripWall& wall, const GridGeometry& building,
                                const BuildingFrame& frame, const GridGeometry& map) {
  std::vector<LineCell> line;
  const auto add = [&](const Position& from, const Position& to, bool is_wall) {
    Ray(map, frame.toMap(from), frame.toMap(to)).forEachCell([&](Cell c) {
      if (map.contains(c) && (line.empty() || line.back().cell != c)) {
        line.push_back({c, is_wall});
      } else if (!line.empty() && line.back().cell == c) {
        line.back().is_wall |= is_wall;
      }
    });
  };
  const auto at = [&](std::size_t i) { return building.centre(wall.cells[i]); };
  const std::size_t last = wall.cells.size() - 1;
  const double steps = kBesideDoor / building.resolution();
  add(at(0) + steps * (at(0) - at(1)), at(0), false);
  for (std::size_t i = 1; i <= last; ++i) {
    add(at(i - 1), at(i), true);
  }
  add(at(last), at(last) + steps * (at(last) - at(last - 1)), false);
  return line;
}

}  // namespace

Mask wallsOnMap(const std::vector<StripWall>& found, const GridGeometry& building,
                const BuildingFrame& frame, const Mask& open) {
  const auto margin = std::lround(kBesideDoor / open.geometry.resolution());
  Mask walls(open.geometry);
  for (const StripWall& wall : found) {
    if (wall.is_outer || wall.cells.size() < 2) {
      continue;
    }
    const std::vector<LineCell> line = lineOnMap(wall, building, frame, open.geometry);
    for (auto one = line.begin(); one != line.end(); ++one) {
      const auto before = std::min<std::ptrdiff_t>(margin, one - line.begin());
      const auto after = std::min<std::ptrdiff_t>(margin + 1, line.end() - one);
      const bool stands =
          one->is_wall && std::none_of(one - before, one + after, [&](const LineCell& other) {
            return open[other.cell] != 0;
          });
      walls[one->cell] |= static_cast<std::uint8_t>(stands);
    }
  }
  return walls;
}

}  // namespace sfw
