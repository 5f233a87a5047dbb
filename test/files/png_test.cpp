#include "files/png.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "structure_from_wifi/input_error.h"
#include "support/png_writer.h"
#include "support/temporary_folder.h"

namespace sfw {
namespace {

using Bytes = std::vector<std::uint8_t>;
using test::PngContent;

class Png : public test::TemporaryFolder {
 protected:
  TranslucentImage decoded(const PngContent& content, std::uint32_t width) const {
    const auto height = static_cast<std::uint32_t>(content.rows.size());
    return readPng(write("image.png", test::encoded(content, width, height)));
  }

  /// What readPng complains of, without the file's name.
  std::string complaint(const std::string& bytes) const {
    const std::string file = write("bad.png", bytes);
    try {
      readPng(file);
    } catch (const InputError& error) {
      const std::string text = error.what();
      EXPECT_EQ(text.rfind(file + ": ", 0), 0U) << text;
      return text.substr(file.size() + 2);
    }
    return "nothing";
  }
};

/// An image of two columns.
TranslucentImage imageOf(const Bytes& grey, const Bytes& opacity) {
  TranslucentImage image;
  image.grey.width = 2;
  image.grey.height = static_cast<std::int64_t>(grey.size() / 2);
  image.grey.pixels = grey;
  image.opacity = opacity;
  return image;
}

void expectPixels(const TranslucentImage& image, const Bytes& grey, const Bytes& opacity) {
  EXPECT_EQ(image.grey.pixels, grey);
  EXPECT_EQ(image.opacity, opacity);
}

TEST_F(Png, KeepsTheColoursOfAPicture) {
  const std::string file =
      write("colours.png", encodeRgbPng(2, 2, {30, 60, 90, 255, 255, 255, 0, 0, 0, 9, 0, 0}));
  expectPixels(readPng(file, GreyOf::kMean), {60, 255, 0, 3}, {255, 255, 255, 255});
}

TEST_F(Png, ReadsGreyOfEachDepth) {
  expectPixels(decoded({PNG_COLOR_TYPE_GRAY, 1, {{0b01000000}}}, 3), {0, 255, 0}, {255, 255, 255});
  expectPixels(decoded({PNG_COLOR_TYPE_GRAY, 2, {{0b00011011}}}, 4), {0, 85, 170, 255},
               {255, 255, 255, 255});
  expectPixels(decoded({PNG_COLOR_TYPE_GRAY, 4, {{0x0f}, {0xa5}}}, 2), {0, 255, 170, 85},
               {255, 255, 255, 255});
  expectPixels(decoded({PNG_COLOR_TYPE_GRAY, 8, {{0, 100, 255}}}, 3), {0, 100, 255},
               {255, 255, 255});
  // 0x4040 is a quarter of full scale, as 0x40 is.
  expectPixels(decoded({PNG_COLOR_TYPE_GRAY, 16, {{0x40, 0x40, 0xff, 0xff}}}, 2), {0x40, 255},
               {255, 255});
}

TEST_F(Png, ReadsOpacity) {
  expectPixels(decoded({PNG_COLOR_TYPE_GRAY_ALPHA, 8, {{10, 0, 20, 127, 30, 255}}}, 3),
               {10, 20, 30}, {0, 127, 255});
  expectPixels(decoded({PNG_COLOR_TYPE_RGB_ALPHA, 8, {{7, 7, 7, 3, 9, 9, 9, 200}}}, 2), {7, 9},
               {3, 200});
  PngContent keyed{PNG_COLOR_TYPE_GRAY, 8, {{0, 5}}};
  keyed.black_is_transparent = true;
  expectPixels(decoded(keyed, 2), {0, 5}, {0, 255});
  keyed = {PNG_COLOR_TYPE_RGB, 8, {{0, 0, 0, 5, 5, 5}}};
  keyed.black_is_transparent = true;
  expectPixels(decoded(keyed, 2), {0, 5}, {0, 255});
}

TEST_F(Png, ColoursBecomeLuma) {
  expectPixels(decoded({PNG_COLOR_TYPE_RGB, 8, {{255, 0, 0, 0, 255, 0, 0, 0, 255, 90, 90, 90}}}, 4),
               {76, 150, 29, 90}, {255, 255, 255, 255});
  expectPixels(decoded({PNG_COLOR_TYPE_RGB, 16, {{0xff, 0xff, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1}}}, 2),
               {76, 1}, {255, 255});
}

TEST_F(Png, ReadsPalettes) {
  PngContent content{PNG_COLOR_TYPE_PALETTE, 2, {{0b00011000}}};
  content.palette = {{255, 0, 0}, {0, 0, 0}, {200, 200, 200}};
  expectPixels(decoded(content, 3), {76, 0, 200}, {255, 255, 255});
  content.palette_opacity = {255, 0};  // of the first colours; the others are opaque
  expectPixels(decoded(content, 3), {76, 0, 200}, {255, 0, 255});
}

TEST_F(Png, IgnoresGamma) {
  PngContent content{PNG_COLOR_TYPE_GRAY, 8, {{64, 128}}};
  content.gamma = 1.0;
  expectPixels(decoded(content, 2), {64, 128}, {255, 255});
  content = {PNG_COLOR_TYPE_RGB, 8, {{255, 0, 0}}};
  content.gamma = 1.0;
  expectPixels(decoded(content, 1), {76}, {255});
}

TEST_F(Png, ReadsInterlacedImages) {
  PngContent content;
  Bytes pixels;
  for (std::uint8_t y = 0; y < 9; ++y) {
    content.rows.emplace_back();
    for (std::uint8_t x = 0; x < 9; ++x) {
      content.rows.back().push_back(static_cast<std::uint8_t>(20 * y + x));
      pixels.push_back(content.rows.back().back());
    }
  }
  content.interlaced = true;
  expectPixels(decoded(content, 9), pixels, Bytes(81, 255));
}

TEST_F(Png, ReadsWhatItEncodes) {
  const TranslucentImage image = imageOf({0, 1, 2, 3, 254, 255}, {255, 0, 1, 128, 254, 255});
  const TranslucentImage again = readPng(write("image.png", encodePng(image)));
  EXPECT_EQ(again.grey.width, 2);
  EXPECT_EQ(again.grey.height, 3);
  expectPixels(again, image.grey.pixels, image.opacity);
}

TEST_F(Png, SaysWhatIsWrongAndWhatToDo) {
  EXPECT_EQ(complaint(""), "not a PNG image; convert it, e.g. with ImageMagick");
  EXPECT_EQ(complaint("P5 1 1 255\na"), "not a PNG image; convert it, e.g. with ImageMagick");
  const std::string whole = encodePng(imageOf({1, 2}, {255, 255}));
  for (std::size_t size = 8; size < whole.size(); ++size) {
    const std::string why = complaint(whole.substr(0, size));
    EXPECT_EQ(why,
              "the PNG image is damaged or cut short (unexpected end of file); save or copy it "
              "again")
        << size;
  }
  std::string damaged = whole;
  damaged[18] = '\x7f';  // the header's checksum no longer fits
  EXPECT_NE(complaint(damaged).find("CRC error"), std::string::npos) << complaint(damaged);
}

TEST_F(Png, RefusesHugeImagesBeforeAllocating) {
  const std::string header = test::encoded({}, 1'000'000, 1'000'000);
  EXPECT_EQ(complaint(header),
            "the picture must have 1 to 64000000 pixels; it has 1000000 x 1000000; scale it down");
}

TEST_F(Png, NamesAnAbsentFile) { EXPECT_THROW(readPng(path("absent.png")), InputError); }

}  // namespace
}  // namespace sfw
