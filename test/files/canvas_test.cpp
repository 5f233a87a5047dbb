#include "files/canvas.h"

#include <gtest/gtest.h>

#include "files/png.h"

namespace sfw {
namespace {

constexpr Colour kInk{0.2, 0.4, 0.6};
constexpr Colour kOther{0.9, 0.1, 0.1};
const GridGeometry kGrid(0.37, {-1.0, -2.0}, 23, 17);

// Pictures are compared as a whole; EXPECT_EQ would print their bytes.

std::string filled(const std::vector<std::int64_t>& columns_modulo_three) {
  Canvas canvas(kGrid.box());
  for (const std::int64_t column : columns_modulo_three) {
    canvas.fillCells(kGrid, kInk, [&](Cell c) { return c.y != 5 && c.x % 3 == column; });
  }
  return canvas.png();
}

TEST(Canvas, FillsARowOfCellsAsItFillsThemOneByOne) {
  Canvas whole(kGrid.box());
  whole.fillCells(kGrid, kInk, [](Cell c) { return c.y != 5; });
  const std::string in_rows = whole.png();
  EXPECT_TRUE(in_rows == filled({0, 1, 2}));
  EXPECT_FALSE(in_rows == filled({0, 1}));
}

std::string dotted(const std::vector<std::pair<Position, Colour>>& dots) {
  Canvas canvas(kGrid.box());
  canvas.drawDots(dots);
  return canvas.png();
}

TEST(Canvas, DrawsADotOnceWhereARobotStands) {
  const Position at(1.0, 1.0);
  const std::string one = dotted({{at, kInk}});
  EXPECT_TRUE(dotted({{at, kInk}, {at, kInk}, {at, kInk}}) == one);
  EXPECT_FALSE(dotted({{at, kInk}, {{3.0, 1.0}, kInk}}) == one);
}

TEST(Canvas, DrawsTheLastOfSeveralColoursOnTop) {
  const Position at(1.0, 1.0);
  const std::string last_is_ink = dotted({{at, kInk}, {at, kOther}, {at, kInk}});
  const std::string last_is_other = dotted({{at, kInk}, {at, kOther}});
  EXPECT_FALSE(last_is_ink == last_is_other);
}

}  // namespace
}  // namespace sfw
