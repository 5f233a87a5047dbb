#include "files/map_server.h"

#include <gtest/gtest.h>

#include "files/png.h"
#include "structure_from_wifi/input_error.h"
#include "support/ascii_world.h"
#include "support/map_server_files.h"

namespace sfw {
namespace {

using test::rowsOf;

using MapServer = test::MapServerFiles;

TEST_F(MapServer, ReadsPlainTextTopRowFirst) {
  const Grid<CellState> map = readMap(file(kYaml, "P2\n3 2\n255\n254 0 205\n0 0 254\n"));
  EXPECT_EQ(rowsOf(map), (Rows{".#?",  //
                               "##."}));
  EXPECT_EQ(map.geometry, GridGeometry(0.1, {-1.5, 2.0}, 3, 2));
}

TEST_F(MapServer, ReadsBinary) {
  EXPECT_EQ(rowsOf(readMap(file(kYaml, std::string("P5\n3 2\n255\n\xfe\0\xcd\0\0\xfe", 17)))),
            (Rows{".#?",  //
                  "##."}));
}

TEST_F(MapServer, BinaryPixelsMayLookLikeBlanksOrComments) {
  EXPECT_EQ(rowsOf(readMap(file(kYaml, "P5 3 1 255\n\n# "))), (Rows{"###"}));
}

TEST_F(MapServer, SkipsComments) {
  const std::string image =
      "P2\n# CREATOR: map_saver 0.050 m/pix\n2 # width\n1\n#\n255\n# pixels\n254 0";
  EXPECT_EQ(rowsOf(readMap(file(kYaml, image))), (Rows{".#"}));
}

TEST_F(MapServer, ScalesPixelsByTheirGreatestValue) {
  EXPECT_EQ(rowsOf(readMap(file(kYaml, "P2 3 1 100 100 80 0"))), (Rows{".?#"}));
  // Beyond it, as only P5 allows, is as white as can be.
  EXPECT_EQ(rowsOf(readMap(file(kYaml, "P5 2 1 100\n\xc8\x64"))), (Rows{".."}));
}

TEST_F(MapServer, NegateSwapsBlackAndWhite) {
  EXPECT_EQ(rowsOf(readMap(file(kYaml + "negate: 1\n", "P2 3 1 255 254 0 128"))), (Rows{"#.?"}));
  EXPECT_EQ(rowsOf(readMap(file(kYaml + "negate: 0\n", "P2 3 1 255 254 0 128"))), (Rows{".#?"}));
}

TEST_F(MapServer, ThresholdsAreTheFilesOwn) {
  // 205 stands for 0.196 and 140 for 0.451.
  const std::string image = "P2 2 1 255 205 140";
  EXPECT_EQ(rowsOf(readMap(file(kYaml, image))), (Rows{"??"}));
  EXPECT_EQ(rowsOf(readMap(file(kYaml + "free_thresh: 0.25\noccupied_thresh: 0.4\n", image))),
            (Rows{".#"}));
}

TEST_F(MapServer, ProbabilitiesAreDarkness) {
  const Grid<float> map = readProbabilities(file(kYaml + "mode: scale\n", "P2 3 1 255 255 51 0"));
  EXPECT_FLOAT_EQ((map[{0, 0}]), 0.0F);
  EXPECT_FLOAT_EQ((map[{1, 0}]), 0.8F);
  EXPECT_FLOAT_EQ((map[{2, 0}]), 1.0F);
}

/// An image of three columns.
std::string png(const std::vector<std::uint8_t>& grey, const std::vector<std::uint8_t>& opacity) {
  TranslucentImage image;
  image.grey.width = 3;
  image.grey.height = static_cast<std::int64_t>(grey.size()) / 3;
  image.grey.pixels = grey;
  image.opacity = opacity;
  return encodePng(image);
}

TEST_F(MapServer, ReadsPng) {
  const std::string yaml = "image: map.png\nresolution: 0.1\norigin: [0, 0, 0]\n";
  // Top row: free, occupied, transparent. Bottom row: between, occupied, free.
  write("map.png", png({254, 0, 0, 205, 1, 255}, {255, 255, 0, 255, 255, 255}));
  EXPECT_EQ(rowsOf(readMap(file(yaml, ""))), (Rows{".#?",  //
                                                   "?#."}));
}

TEST_F(MapServer, RefusesABrokenPng) {
  const std::string yaml = "image: map.png\nresolution: 0.1\norigin: [0, 0, 0]\n";
  const std::string whole = png({1, 2, 3}, {255, 255, 255});
  for (const std::string& image :
       {std::string(), std::string("P2 1 1 255"), whole.substr(0, 20), whole.substr(0, 50)}) {
    write("map.png", image);
    const std::string why = complaint(yaml, "");
    EXPECT_NE(why.find("map.png"), std::string::npos) << image.size() << ": " << why;
  }
}

TEST_F(MapServer, AnAbsoluteImagePathStandsForItself) {
  write("other.pgm", "P2 1 1 255 0");
  const std::string image = (folder_ / "other.pgm").string();
  EXPECT_EQ(rowsOf(readMap(file("image: " + image + "\nresolution: 0.1\norigin: [0, 0, 0]\n", ""))),
            (Rows{"#"}));
}

TEST_F(MapServer, RefusesATruncatedImage) {
  for (const char* image : {"P5 3 2 255\nabcde", "P5 3 2 255", "P5 3 2 255\n",
                            "P2 3 2 255 1 2 3 4 5", "P5 3 2", "P5 3", "P5", "P2\n# no end"}) {
    const std::string why = complaint(kYaml, image);
    EXPECT_NE(why.find("map.pgm"), std::string::npos) << image << ": " << why;
  }
  EXPECT_NO_THROW(readMap(file(kYaml, "P5 3 2 255\nabcdef")));
}

TEST_F(MapServer, RefusesOtherImages) {
  for (const char* image : {"", "P", "P6 1 1 255\nab", "GIF89a", "\x89PNG\r\n", "hello"}) {
    const std::string why = complaint(kYaml, image);
    EXPECT_NE(why.find("map.pgm"), std::string::npos) << image << ": " << why;
  }
}

TEST_F(MapServer, RefusesHostileSizesBeforeAllocating) {
  for (const char* image :
       {"P5 262144 262144 255\nabc", "P2 262144 262144 255 0", "P5 262145 1 255\nabc",
        "P5 99999999999999999999999999 1 255\nabc", "P5 0 1 255\nabc", "P5 -1 1 255\nabc",
        "P5 1 1 0\nabc", "P5 1 1 65535\na", "P5 1 1 65536\nab", "P2 1 1 255 256", "P2 1 1 255 -1",
        "P2 1 1 255 x", "P2 1.5 1 255 0"}) {
    const std::string why = complaint(kYaml, image);
    EXPECT_NE(why.find("map.pgm"), std::string::npos) << image << ": " << why;
  }
}

TEST_F(MapServer, RefusesAnOriginThatIsNoPlace) {
  const std::string yaml = "image: map.pgm\nresolution: 0.1\norigin: ";
  for (const char* origin :
       {"[0, 0, .nan]", "[0]", "{x: 1}", "[]", "5", "[a, b, c]", "[.nan, 0, 0]", "[0, .inf, 0]"}) {
    const std::string why = complaint(yaml + origin + "\n", "P2 1 1 255 0");
    EXPECT_NE(why.find("map.yaml"), std::string::npos) << origin << ": " << why;
  }
  EXPECT_NO_THROW(readMap(file(yaml + "[0, 0]\n", "P2 1 1 255 0")));
  EXPECT_NO_THROW(readMap(file(yaml + "[0, 0, -0.0]\n", "P2 1 1 255 0")));
}

TEST_F(MapServer, NamesAMissingKey) {
  const std::string image = "P2 1 1 255 0";
  EXPECT_NE(complaint("resolution: 0.1\norigin: [0, 0, 0]\n", image).find("image"),
            std::string::npos);
  EXPECT_NE(complaint("image: map.pgm\norigin: [0, 0, 0]\n", image).find("resolution"),
            std::string::npos);
  EXPECT_NE(complaint("image: map.pgm\nresolution: 0.1\n", image).find("origin"),
            std::string::npos);
}

TEST_F(MapServer, RefusesValuesThatMakeNoSense) {
  for (const char* line :
       {"negate: perhaps", "occupied_thresh: high", "free_thresh: .nan", "occupied_thresh: 1.5",
        "free_thresh: 0.9", "free_thresh: -0.1", "mode: rare", "mode: 3", "negate: [1]"}) {
    const std::string why = complaint(kYaml + line + "\n", "P2 1 1 255 0");
    EXPECT_NE(why.find("map.yaml"), std::string::npos) << line << ": " << why;
  }
  for (const char* resolution : {"0", "-1", ".nan", ".inf", "fine", "[0.1]"}) {
    const std::string why = complaint(
        std::string("image: map.pgm\norigin: [0, 0, 0]\nresolution: ") + resolution + "\n",
        "P2 1 1 255 0");
    EXPECT_NE(why.find("map.yaml"), std::string::npos) << resolution << ": " << why;
  }
}

TEST_F(MapServer, RefusesWhatIsNoMap) {
  for (const char* yaml : {"", "just text", "[1, 2]", "{", "image: [", "\t- x: :"}) {
    const std::string why = complaint(yaml, "P2 1 1 255 0");
    EXPECT_NE(why.find("map.yaml"), std::string::npos) << yaml << ": " << why;
  }
  EXPECT_THROW(readMap((folder_ / "absent.yaml").string()), InputError);
  EXPECT_THROW(readMap(folder_.string()), InputError);
  EXPECT_NE(
      complaint("image: absent.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n", "").find("absent.pgm"),
      std::string::npos);
}

TEST_F(MapServer, ReadsWallLossesInDecibels) {
  const std::string image = "P2\n2 1\n255\n0 40\n";
  const Grid<float> loss =
      readWallLoss(file(kYaml + "mode: scale\nnegate: 1\ndecibels_per_step: 0.05\n", image));
  EXPECT_NEAR(loss.cells[0], 0.0F, 1e-6F);
  EXPECT_NEAR(loss.cells[1], 2.0F, 1e-6F);
  EXPECT_THROW(readWallLoss(file(kYaml + "mode: scale\nnegate: 1\n", image)), InputError);
}

}  // namespace
}  // namespace sfw
