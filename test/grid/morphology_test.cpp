#include "grid/morphology.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "support/ascii_world.h"

namespace sfw {
namespace {

using Rows = std::vector<std::string>;
using test::mask;
using test::rowsOf;

TEST(Dilated, IsADisc) {
  EXPECT_EQ(rowsOf(dilated(mask({".....",  //
                                 ".....",  //
                                 "..#..",  //
                                 ".....",  //
                                 "....."}),
                           2.0)),
            (Rows{"..#..",  //
                  ".###.",  //
                  "#####",  //
                  ".###.",  //
                  "..#.."}));
}

TEST(Dilated, EmptySetStaysEmpty) {
  EXPECT_EQ(rowsOf(dilated(mask({"...", "..."}), 1e9)), (Rows{"...", "..."}));
}

TEST(Closed, ClosesTheGapThatTheDiscDoesNotFitInto) {
  EXPECT_EQ(rowsOf(closed(mask({"##.....##",  //
                                "####.####",  //
                                "####.####",  //
                                "#########"}),
                          1.0)),
            (Rows{"##.....##",  //
                  "####.####",  // a disc in the mouth reaches down here
                  "#########",  //
                  "#########"}));
}

TEST(Closed, DoesNotGrowAlongTheBorderOfTheGrid) {
  const Rows line = {".....",  //
                     "#####",  //
                     "....."};
  EXPECT_EQ(rowsOf(closed(mask(line), 3.0)), line);
  EXPECT_EQ(rowsOf(closed(mask({"#...#"}), 0.0)), (Rows{"#...#"}));
}

TEST(Closed, RefusesARadiusThatFitsNoGrid) {
  for (const double radius : {-1.0, 1e9, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(closed(mask({"#"}), radius), std::invalid_argument);
  }
}

TEST(WithHolesFilled, FillsWhatIsEnclosedOverEdges) {
  EXPECT_EQ(rowsOf(withHolesFilled(mask({".###....",  //
                                         ".#.#.##.",  //
                                         ".##.#..#",  // this hole touches another by a corner
                                         "..###.#.",  // and this one is open there
                                         "......#."}))),
            (Rows{".###....",  //
                  ".###.##.",  //
                  ".####..#",  //
                  "..###.#.",  //
                  "......#."}));
}

TEST(WithHolesFilled, LeavesABayAtTheBorderOpen) {
  const Rows bay = {"##.##",  //
                    "#...#",  //
                    "#####"};
  EXPECT_EQ(rowsOf(withHolesFilled(mask(bay))), bay);
}

TEST(LabelComponents, JoinsOverEdgesNotCorners) {
  const Components components = labelComponents(mask({"##..#",  //
                                                      "..#.#",  //
                                                      "..###"}));
  // Numbered from the lowest row upwards.
  EXPECT_EQ(rowsOf(components.label, [](std::int64_t l) { return static_cast<char>('0' + l); }),
            (Rows{"22001",  //
                  "00101",  //
                  "00111"}));
  EXPECT_EQ(components.count, 2);
}

TEST(LabelComponents, JoinsOverCornersIfAsked) {
  const Mask diagonal = mask({"#.#",  //
                              ".#.",  //
                              "..."});
  EXPECT_EQ(labelComponents(diagonal).count, 3);
  EXPECT_EQ(labelComponents(diagonal, Connectivity::kEdgesAndCorners).count, 1);
}

TEST(LabelComponents, OfAnEmptySetAreNone) { EXPECT_EQ(labelComponents(mask({".."})).count, 0); }

}  // namespace
}  // namespace sfw
