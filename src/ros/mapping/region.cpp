#include "ros/mapping/region.h"

#include <cstddef>

namespace sfw {

bool contains(const std::vector<Position>& polygon, const Position& point) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Position& a = polygon[i];
    const Position& b = polygon[(i + 1) % polygon.size()];
    if ((a.y() > point.y()) != (b.y() > point.y()) &&
        point.x() < a.x() + (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y())) {
      inside = !inside;
    }
  }
  return inside;
}

}  // namespace sfw
