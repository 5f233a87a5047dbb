#include "files/gif.h"

#include <gtest/gtest.h>

#include <map>

#include "structure_from_wifi/input_error.h"
#include "support/complaint.h"

namespace sfw {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Codes of LZW as a GIF has them, in blocks, with the width of the numbers before.
std::string packed(const Bytes& numbers, unsigned bits_of_number) {
  const unsigned clear = 1U << bits_of_number;
  std::string bytes;
  std::uint64_t bits = 0;
  unsigned bit_count = 0;
  unsigned width = bits_of_number + 1;
  const auto put = [&](unsigned code) {
    bits |= std::uint64_t{code} << bit_count;
    for (bit_count += width; bit_count >= 8; bit_count -= 8, bits >>= 8U) {
      bytes.push_back(static_cast<char>(bits));
    }
  };
  std::map<std::string, unsigned> codes;
  unsigned next = 0;
  const auto reset = [&] {
    put(clear);
    codes.clear();
    for (unsigned i = 0; i < clear; ++i) {
      codes[std::string(1, static_cast<char>(i))] = i;
    }
    next = clear + 2;
    width = bits_of_number + 1;
  };
  reset();
  std::string sequence;
  for (const std::uint8_t number : numbers) {
    const std::string longer = sequence + static_cast<char>(number);
    if (codes.count(longer) > 0) {
      sequence = longer;
      continue;
    }
    put(codes[sequence]);
    if (next == 4096) {
      reset();
    } else {
      codes[longer] = next++;
      width += next > (1U << width) ? 1 : 0;
    }
    sequence = std::string(1, static_cast<char>(number));
  }
  put(codes[sequence]);
  put(clear + 1);
  bytes.push_back(static_cast<char>(bits));
  std::string blocks(1, static_cast<char>(bits_of_number));
  for (std::size_t at = 0; at < bytes.size(); at += 255) {
    const std::string block = bytes.substr(at, 255);
    blocks += static_cast<char>(block.size()) + block;
  }
  return blocks + '\0';
}

std::string number(int value) { return {static_cast<char>(value), static_cast<char>(value >> 8)}; }

/// A GIF of one picture, whose colours are grey values in steps of 256 / their number.
struct Gif {
  int width = 3, height = 1;  // of the canvas
  int left = 0, top = 0, columns = 3, rows = 1;
  Bytes numbers;
  unsigned bits = 2;
  bool is_interlaced = false;
  int transparent = -1;

  std::string bytes() const {
    std::string text =
        "GIF89a" + number(width) + number(height) + static_cast<char>(0x80 | (bits - 1));
    text += std::string(2, '\0');
    for (int i = 0; i < 1 << bits; ++i) {
      text += std::string(3, static_cast<char>(i * (256 >> bits)));
    }
    if (transparent >= 0) {
      text += std::string("\x21\xf9\4\1\0\0", 6) + static_cast<char>(transparent) + '\0';
    }
    text += std::string("\x21\xfe\2hi\0", 6) + ',';  // a comment
    text += number(left) + number(top) + number(columns) + number(rows);
    text += static_cast<char>(is_interlaced ? 0x40 : 0);
    return text + packed(numbers, bits) + ';';
  }
};

Gif small() {
  Gif gif;
  gif.numbers.assign(3, 0);
  gif.numbers[1] = 1;
  gif.numbers[2] = 3;
  return gif;
}

TranslucentImage decoded(const Gif& gif) { return decodeGif(gif.bytes(), "a.gif"); }

TEST(Gif, GivesTheGreyOfItsColours) {
  EXPECT_TRUE(isGif(small().bytes()));
  EXPECT_FALSE(isGif("GIF90a"));
  const TranslucentImage image = decoded(small());
  EXPECT_EQ(image.grey.width, 3);
  EXPECT_EQ(image.grey.height, 1);
  EXPECT_EQ(image.grey.pixels, (Bytes{0, 64, 192}));
  EXPECT_EQ(image.opacity, Bytes(3, 255));
}

TEST(Gif, UnpacksLongSequencesAndFullTables) {
  Gif gif;
  gif.width = gif.columns = 300;
  gif.height = gif.rows = 200;
  gif.bits = 8;
  gif.numbers.clear();
  std::uint32_t state = 1;
  for (int i = 0; i < 300 * 200; ++i) {
    state = state * 1664525U + 1013904223U;
    const bool is_wall = i / 9000 % 2 == 0;  // long runs, and noise
    gif.numbers.push_back(is_wall ? 7 : static_cast<std::uint8_t>(state >> 24U));
  }
  EXPECT_EQ(decoded(gif).grey.pixels, gif.numbers);
}

TEST(Gif, PutsTheRowsOfAnInterlacedPictureInOrder) {
  Gif gif;
  gif.width = gif.columns = 1;
  gif.height = gif.rows = 9;
  gif.bits = 4;
  gif.is_interlaced = true;
  gif.numbers = {0, 8, 4, 2, 6, 1, 3, 5, 7};  // the rows in the order of the four passes
  EXPECT_EQ(decoded(gif).grey.pixels, (Bytes{0, 16, 32, 48, 64, 80, 96, 112, 128}));
}

TEST(Gif, IsTransparentBesideItsPictureAndInOneColour) {
  Gif gif = small();
  gif.width = 5;
  gif.left = 1;
  gif.transparent = 1;
  EXPECT_EQ(decoded(gif).opacity, (Bytes{0, 255, 0, 255, 0}));
  EXPECT_EQ(decoded(gif).grey.pixels[3], 192);
}

TEST(Gif, LeavesOutNumbersBeyondThePicture) {
  Gif gif = small();
  gif.numbers.resize(1000, 2);
  EXPECT_EQ(decoded(gif).grey.pixels, decoded(small()).grey.pixels);
}

TEST(Gif, RefusesWhatIsCutOrDamaged) {
  const std::string whole = small().bytes();
  for (std::size_t size = 6; size + 2 < whole.size(); ++size) {
    EXPECT_THROW(decodeGif(whole.substr(0, size), "a.gif"), InputError) << size;
  }
  const auto complaint = [](const Gif& gif) { return test::complaintOf([&] { decoded(gif); }); };
  Gif beyond = small();
  beyond.left = 1;
  EXPECT_EQ(complaint(beyond),
            "a.gif: the GIF image is damaged or cut short; save or copy it again");
  Gif few = small();
  few.numbers.pop_back();
  EXPECT_NE(complaint(few).find("cut short"), std::string::npos);
  Gif huge = small();
  huge.width = huge.height = 65535;
  EXPECT_NE(complaint(huge).find("64000000 pixels"), std::string::npos);
}

}  // namespace
}  // namespace sfw
