#include "grid/cells_at_centres.h"

#include <gtest/gtest.h>

#include "grid/for_each_cell.h"

namespace sfw {
namespace {

TEST(CellsAtCentres, AreThoseOfCellAtInsideAndOutsideOfTheGrid) {
  const GridGeometry centres_of(0.2, {-1.13, 2.4}, 30, 17);
  const GridGeometry cells_of(0.05, {-0.9, 2.55}, 90, 40);
  const CellsAtCentres cells(centres_of, cells_of);
  const CellsAtCentres back(cells_of, centres_of);
  forEachCell(centres_of,
              [&](Cell c) { ASSERT_EQ(cells[c], cells_of.cellAt(centres_of.centre(c))); });
  forEachCell(cells_of, [&](Cell c) { ASSERT_EQ(back[c], centres_of.cellAt(cells_of.centre(c))); });
}

}  // namespace
}  // namespace sfw
