#include "grid/contour.h"

#include <array>

#include "grid/for_each_cell.h"

namespace sfw {
namespace {

/// East, north, west, south: each is a left turn from the previous one.
constexpr std::array<Cell, 4> kHeadings{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

unsigned leftOf(unsigned heading) { return (heading + 1) % 4; }
unsigned rightOf(unsigned heading) { return (heading + 3) % 4; }

Cell step(Cell c, unsigned heading) {
  return {c.x + kHeadings[heading].x, c.y + kHeadings[heading].y};
}

/// Walks along the borders of a set. The border is always to the right.
class BorderWalk {
 public:
  explicit BorderWalk(const Mask& mask) : mask_(mask), walked_(mask.geometry) {}

  /// Whether a cell has a border to the right of a heading, and the walk has not passed it yet.
  bool starts(Cell c, unsigned heading) const {
    return in(c) && !in(step(c, rightOf(heading))) && (walked_[c] >> heading & 1u) == 0;
  }

  std::vector<Cell> walk(Cell c, unsigned heading) {
    std::vector<Cell> cells{c};
    while ((walked_[c] >> heading & 1u) == 0) {
      walked_[c] = static_cast<std::uint8_t>(walked_[c] | 1u << heading);
      const Cell ahead = step(c, heading);
      if (!in(ahead)) {
        heading = leftOf(heading);
        continue;
      }
      cells.push_back(ahead);
      c = ahead;
      const Cell right = step(ahead, rightOf(heading));
      if (in(right)) {
        heading = rightOf(heading);
        cells.push_back(right);
        c = right;
      }
    }
    if (cells.size() > 1) {
      cells.pop_back();  // it is back at the first cell
    }
    return cells;
  }

 private:
  bool in(Cell c) const { return mask_.geometry.contains(c) && mask_[c] != 0; }

  const Mask& mask_;
  Grid<std::uint8_t> walked_;  // one bit a heading
};

}  // namespace

std::vector<std::vector<Cell>> contours(const Mask& mask) {
  BorderWalk border(mask);
  std::vector<std::vector<Cell>> found;
  forEachCell(mask.geometry, [&](Cell c) {
    for (unsigned heading = 0; heading < kHeadings.size(); ++heading) {
      if (border.starts(c, heading)) {
        found.push_back(border.walk(c, heading));
      }
    }
  });
  return found;
}

}  // namespace sfw
