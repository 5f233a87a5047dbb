#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "files/png.h"
#include "simulation/building/floor_plan_io.h"
#include "support/ascii_world.h"
#include "support/floor_plan_files.h"
#include "support/png_writer.h"

namespace sfw {
namespace {

using Rows = std::vector<std::string>;

class FloorPlanPng : public test::FloorPlanFiles {
 protected:
  /// A PNG of one pixel a character: '#' black, '.' white, 'g' grey, ' ' transparent.
  std::string picture(const Rows& rows) const {
    TranslucentImage image;
    image.grey.width = static_cast<std::int64_t>(rows.front().size());
    image.grey.height = static_cast<std::int64_t>(rows.size());
    for (const std::string& row : rows) {
      for (const char c : row) {
        image.grey.pixels.push_back(c == '#' ? 0 : c == 'g' ? 178 : 255);
        image.opacity.push_back(c == ' ' ? 0 : 255);
      }
    }
    return write("plan.png", encodePng(image));
  }
};

TEST_F(FloorPlanPng, ReadsPictures) {
  FloorPlanOptions options;
  options.metres_per_pixel = 0.2;
  const FloorPlan plan = readFloorPlan(picture({"        ",  //
                                                " ...... ",  //
                                                " .####. ",  //
                                                " .#g.#. ",  //
                                                " .####. ",  //
                                                "        "}),
                                       options);
  EXPECT_EQ(test::rowsOf(toStates(plan)), (Rows{"????????",  //
                                                "?......?",  //
                                                "?.####.?",  //
                                                "?.#..#.?",  //
                                                "?.####.?",  //
                                                "????????"}));
  EXPECT_EQ(plan.geometry, GridGeometry(0.2, {0.0, 0.0}, 8, 6));
}

TEST_F(FloorPlanPng, WhiteAroundTheBuildingIsOutside) {
  FloorPlanOptions options;
  options.metres_per_pixel = 0.2;
  const std::string file = picture({".......",  //
                                    ".#####.",  //
                                    ".#...#.",  //
                                    ".#####.",  //
                                    "......."});
  EXPECT_EQ(test::rowsOf(readFloorPlan(file, options),
                         [](Material m) { return "?.IO"[static_cast<int>(m)]; }),
            (Rows{"???????",  //
                  "?OOOOO?",  //
                  "?O...O?",  //
                  "?OOOOO?",  //
                  "???????"}));
}

/// A picture of black walls '#', white '.' and transparent black ' '.
std::string translucent(const Rows& rows) {
  test::PngContent content{PNG_COLOR_TYPE_GRAY_ALPHA, 8, {}};
  for (const std::string& row : rows) {
    std::vector<std::uint8_t> bytes;
    for (const char c : row) {
      bytes.push_back(c == '.' ? 255 : 0);
      bytes.push_back(c == ' ' ? 0 : 255);
    }
    content.rows.push_back(bytes);
  }
  return test::encoded(content, static_cast<std::uint32_t>(rows[0].size()),
                       static_cast<std::uint32_t>(rows.size()));
}

TEST_F(FloorPlanPng, ReadsWallsOnATransparentGround) {
  FloorPlanOptions options;
  options.metres_per_pixel = 0.2;
  const Rows plan{"?????????",  //
                  "?#######?",  //
                  "?#..#..#?",  //
                  "?#.....#?",  //
                  "?#######?",  //
                  "?????????"};
  const auto read = [&](const Rows& rows) {
    return test::rowsOf(toStates(readFloorPlan(write("plan.png", translucent(rows)), options)));
  };
  EXPECT_EQ(read({"         ",  //
                  " ####### ",  //
                  " #  #  # ",  //
                  " #    .# ",  // a white label
                  " ####### ",  //
                  "         "}),
            plan);
  // White floor with transparency around it, and in a shaft.
  EXPECT_EQ(read({"         ",  //
                  " ####### ",  //
                  " #..#..# ",  //
                  " #... .# ",  //
                  " ####### ",  //
                  "         "})[3],
            "?#...?.#?");
}

TEST_F(FloorPlanPng, SaysWhatIsWrongWithAPicture) {
  FloorPlanOptions options;
  const std::string leak = picture({"###", "...", "###"});
  EXPECT_EQ(complaintOf(leak), "a PNG has no scale: give metres per pixel");
  options.metres_per_pixel = 0.1;
  EXPECT_NE(complaintOf(leak, options).find("no enclosed room"), std::string::npos);
  EXPECT_EQ(complaintOf(write("a.png", "nothing of the kind"), options),
            "not a PNG image; convert it, e.g. with ImageMagick");
  std::ifstream stream(leak, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  EXPECT_NE(complaintOf(write("b.png", bytes.substr(0, 40)), options).find("cut short"),
            std::string::npos);
  const std::string header = test::encoded({}, 32'767, 32'767);
  EXPECT_NE(complaintOf(write("c.png", header), options).find("must have 1 to 64000000 pixels"),
            std::string::npos);
}

TEST_F(FloorPlanPng, MiddleGreyIsWhereWallsBegin) {
  FloorPlanOptions options;
  options.metres_per_pixel = 0.2;
  // A ring of wall around free pixels of different greys, colours and opacities.
  test::PngContent content{PNG_COLOR_TYPE_RGB_ALPHA, 8, {}};
  const auto row = [](const std::vector<std::array<std::uint8_t, 4>>& inner) {
    std::vector<std::uint8_t> bytes{0, 0, 0, 255};
    for (const auto& pixel : inner) {
      bytes.insert(bytes.end(), pixel.begin(), pixel.end());
    }
    bytes.insert(bytes.end(), {0, 0, 0, 255});
    return bytes;
  };
  const std::array<std::uint8_t, 4> black{0, 0, 0, 255};
  content.rows = {row({black, black, black, black, black, black}),
                  row({{127, 127, 127, 255},  // darker than middle grey
                       {128, 128, 128, 255},
                       {255, 0, 0, 255},  // red is dark
                       {0, 255, 0, 255},  // green is bright
                       {0, 0, 0, 127},    // rather transparent
                       {255, 255, 255, 128}}),
                  row({black, black, black, black, black, black})};
  const FloorPlan plan = readFloorPlan(write("plan.png", test::encoded(content, 8, 3)), options);
  EXPECT_EQ(test::rowsOf(toStates(plan)), (Rows{"########",  //
                                                "##.#.?.#",  //
                                                "########"}));
}

TEST_F(FloorPlanPng, ContentDecidesWhereTheNameDoesNot) {
  FloorPlanOptions options;
  options.metres_per_pixel = 0.1;
  std::filesystem::copy(picture({"###", "#.#", "###"}), path("picture"));
  EXPECT_EQ(readFloorPlan(path("picture"), options).geometry.width(), 3);
}

}  // namespace
}  // namespace sfw
