// Maps of other programs: modes, thresholds, yaws and image formats.

#include <gtest/gtest.h>

#include "files/map_server.h"
#include "support/ascii_world.h"
#include "support/map_server_files.h"

namespace sfw {
namespace {

using test::rowsOf;

using MapServerKinds = test::MapServerFiles;

TEST_F(MapServerKinds, TheGreyOfUnknownCellsIsUnknownWithTheThresholdOfNav2) {
  const std::string image = "P2 4 1 255 254 206 205 0";
  const std::string nav2 = kYaml + "free_thresh: 0.25\n";
  EXPECT_EQ(rowsOf(readMap(file(nav2, image))), (Rows{"..?#"}));
  EXPECT_EQ(rowsOf(readMap(file(nav2 + "mode: Trinary\nnegate: false\n", image))), (Rows{"..?#"}));
  // In other maps 205 has no meaning of its own.
  EXPECT_EQ(rowsOf(readMap(file(nav2 + "mode: scale\n", image))), (Rows{"...#"}));
  EXPECT_EQ(rowsOf(readMap(file(nav2 + "negate: true\n", "P2 3 1 255 254 205 50"))), (Rows{"##."}));
}

TEST_F(MapServerKinds, ReadsModeRaw) {
  const std::string raw = kYaml + "mode: raw\n";
  EXPECT_EQ(rowsOf(readMap(file(raw, "P2 5 1 255 0 19 50 100 255"))), (Rows{"..?#?"}));
  EXPECT_EQ(rowsOf(readMap(file(raw + "negate: 1\n", "P2 3 1 255 255 155 0"))), (Rows{".#?"}));
}

TEST_F(MapServerKinds, TurnsByTheYawOfItsOrigin) {
  const std::string image = "P2 3 2 255 254 0 205 0 0 254";  // .#? over ##.
  const auto map_of = [&](const std::string& yaw) {
    return readMap(
        file("image: map.pgm\nresolution: 0.1\norigin: [-1.5, 2.0, " + yaw + "]\n", image));
  };
  for (const char* const yaw : {"1e-17", "6.283185307179586", "-6.2832", "0.01"}) {
    EXPECT_EQ(rowsOf(map_of(yaw)), (Rows{".#?", "##."})) << yaw;
    EXPECT_EQ(map_of(yaw).geometry, GridGeometry(0.1, {-1.5, 2.0}, 3, 2)) << yaw;
  }
  EXPECT_EQ(rowsOf(map_of("3.14")), (Rows{".##", "?#."}));
  EXPECT_LT((map_of("3.14").geometry.origin() - Position(-1.8, 1.8)).norm(), 1e-9);
  EXPECT_EQ(rowsOf(map_of("1.5708")), (Rows{"?.", "##", ".#"}));
  EXPECT_LT((map_of("1.5708").geometry.origin() - Position(-1.7, 2.0)).norm(), 1e-9);
  EXPECT_EQ(rowsOf(map_of("-1.5707963267948966")), (Rows{"#.", "##", ".?"}));
}

TEST_F(MapServerKinds, TurnsByAnyAngle) {
  // A row of 21 cells from the origin to the right, turned to the upper right.
  std::string image = "P2 21 1 255";
  for (int i = 0; i < 21; ++i) {
    image += i % 2 == 0 ? " 0" : " 254";
  }
  const std::string yaml = "image: map.pgm\nresolution: 1\norigin: [5, 7, 0.6435011087932844]\n";
  const Grid<CellState> map = readMap(file(yaml, image));
  for (int i = 0; i < 21; ++i) {  // the way along it is (0.8, 0.6)
    const Position before(i + 0.5, 0.5);
    const Position point(5 + 0.8 * before.x() - 0.6 * before.y(),
                         7 + 0.6 * before.x() + 0.8 * before.y());
    const Cell c = map.geometry.cellAt(point);
    ASSERT_TRUE(map.geometry.contains(c)) << i;
    const Position centre = map.geometry.centre(c) - Position(5, 7);
    const double along = 0.8 * centre.x() + 0.6 * centre.y();
    const double across = 0.8 * centre.y() - 0.6 * centre.x();
    const bool is_on_row = along >= 0 && along < 21 && across >= 0 && across < 1;
    const CellState expected = !is_on_row                         ? CellState::kUnknown
                               : static_cast<int>(along) % 2 == 0 ? CellState::kOccupied
                                                                  : CellState::kFree;
    EXPECT_EQ(map[c], expected) << i;
  }
  EXPECT_EQ((map[{0, map.geometry.height() - 1}]), CellState::kUnknown);
}

TEST_F(MapServerKinds, TellsOfAYawThatIsNoNumber) {
  for (const char* const yaw : {"-nan", "nan", ".nan", "inf"}) {
    const std::string why =
        complaint(std::string("image: map.pgm\nresolution: 0.1\norigin: [0, 0, ") + yaw + "]\n",
                  "P2 1 1 255 0");
    EXPECT_NE(why.find("origin"), std::string::npos) << yaw << ": " << why;
  }
  EXPECT_NE(complaint("image: map.pgm\nresolution: 0.1\norigin: [0, 0, -nan]\n", "P2 1 1 255 0")
                .find("write 0 in its place"),
            std::string::npos);
}

TEST_F(MapServerKinds, Reads16BitsAndOtherFormats) {
  EXPECT_EQ(rowsOf(readMap(file(kYaml, std::string("P5\n2 1\n65535\n\xfe\xff\0\xff", 18)))),
            (Rows{".#"}));
  EXPECT_EQ(rowsOf(readMap(file(kYaml, "P2 2 1 65535 65000 100"))), (Rows{".#"}));
  EXPECT_EQ(rowsOf(readMap(file(kYaml, std::string("P6 2 1 255\n\xff\xff\xff\0\0\0", 17)))),
            (Rows{".#"}));
  // A BMP of 2 x 1 pixels with 24 bits: white, black, and two bytes of filling.
  const std::string bmp(
      "BM\x3e\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\x02\0\0\0\x01\0\0\0\x01\0\x18\0\0\0\0\0"
      "\x08\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\xff\xff\xff\0\0\0\0\0",
      62);
  EXPECT_EQ(rowsOf(readMap(file(kYaml, bmp))), (Rows{".#"}));
}

TEST_F(MapServerKinds, TakesTheMeanOfColoursAsMapServerDoes) {
  // Green is brighter than its mean of 85, which is 0.667.
  const std::string green("P6 1 1 255\n\0\xff\0", 14);
  EXPECT_EQ(rowsOf(readMap(file(kYaml, green))), (Rows{"#"}));
}

}  // namespace
}  // namespace sfw
