#include <cairo.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "simulation/building/floor_plan_io.h"
#include "support/ascii_world.h"
#include "support/floor_plan_files.h"

namespace sfw {
namespace {

using Rows = std::vector<std::string>;

class FloorPlanPng : public test::FloorPlanFiles {
 protected:
  /// A PNG of one pixel a character: '#' black, '.' white, 'g' grey, ' ' transparent.
  std::string picture(const Rows& rows) const {
    const auto width = static_cast<int>(rows.front().size());
    cairo_surface_t* surface =
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, static_cast<int>(rows.size()));
    cairo_t* context = cairo_create(surface);
    for (std::size_t y = 0; y < rows.size(); ++y) {
      for (std::size_t x = 0; x < rows[y].size(); ++x) {
        const double light = rows[y][x] == '#' ? 0.0 : rows[y][x] == 'g' ? 0.7 : 1.0;
        cairo_set_source_rgba(context, light, light, light, rows[y][x] == ' ' ? 0.0 : 1.0);
        cairo_rectangle(context, static_cast<double>(x), static_cast<double>(y), 1.0, 1.0);
        cairo_fill(context);
      }
    }
    cairo_destroy(context);
    cairo_surface_write_to_png(surface, path("plan.png").c_str());
    cairo_surface_destroy(surface);
    return path("plan.png");
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

TEST_F(FloorPlanPng, SaysWhatIsWrongWithAPicture) {
  FloorPlanOptions options;
  const std::string leak = picture({"###", "...", "###"});
  EXPECT_EQ(complaintOf(leak), "a PNG has no scale: give metres per pixel");
  options.metres_per_pixel = 0.1;
  EXPECT_NE(complaintOf(leak, options).find("no enclosed room"), std::string::npos);
  EXPECT_EQ(complaintOf(write("a.png", "nothing of the kind"), options), "not a PNG image");

  std::ifstream stream(leak, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  EXPECT_EQ(complaintOf(write("b.png", bytes.substr(0, 40)), options),
            "the PNG image is damaged or cut short");
  EXPECT_EQ(complaintOf(write("c.png", bytes.substr(0, 20)), options), "not a PNG image");
  bytes[18] = bytes[22] = '\x7f';  // 32 thousand pixels on each side
  EXPECT_NE(complaintOf(write("d.png", bytes), options).find("must have 1 to 64000000 pixels"),
            std::string::npos);
}

TEST_F(FloorPlanPng, ContentDecidesWhereTheNameDoesNot) {
  FloorPlanOptions options;
  options.metres_per_pixel = 0.1;
  std::filesystem::copy(picture({"###", "#.#", "###"}), path("picture"));
  EXPECT_EQ(readFloorPlan(path("picture"), options).geometry.width(), 3);
}

}  // namespace
}  // namespace sfw
