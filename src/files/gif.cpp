#include "files/gif.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

constexpr std::size_t kMostCodes = 4096;

/// Bytes of a GIF, taken from the front.
class GifBytes {
 public:
  GifBytes(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  std::string_view take(std::size_t count) {
    if (count > bytes_.size()) {
      refuse();
    }
    const std::string_view front = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return front;
  }

  std::uint8_t byte() { return static_cast<std::uint8_t>(take(1).front()); }

  std::int64_t number() {
    const std::int64_t low = byte();
    return low + 256 * byte();
  }

  /// The bytes of all blocks up to the empty one.
  std::string blocks() {
    std::string all;
    for (std::size_t size = byte(); size > 0; size = byte()) {
      all += take(size);
    }
    return all;
  }

  [[noreturn]] void refuse() const {
    throw InputError(file_ + ": the GIF image is damaged or cut short; save or copy it again");
  }

 private:
  std::string_view bytes_;
  const std::string& file_;
};

/// The colours of a picture as grey values.
using Palette = std::array<std::uint8_t, 256>;

Palette takePalette(GifBytes& bytes, unsigned flags) {
  Palette palette{};
  const std::size_t colours = std::size_t{2} << (flags & 7U);
  for (std::size_t i = 0; i < colours; ++i) {
    const int red = bytes.byte();
    const int green = bytes.byte();
    palette[i] = static_cast<std::uint8_t>((red + green + bytes.byte()) / 3);
  }
  return palette;
}

/// The sequences of LZW that codes stand for. Each is an earlier one and one more number.
class Sequences {
 public:
  /// @param literals  codes below it stand for themselves; it and the next one are commands
  explicit Sequences(std::size_t literals) : literals_(literals), before_(kMostCodes) {
    last_.resize(kMostCodes);
    for (std::size_t code = 0; code < literals; ++code) {
      last_[code] = static_cast<std::uint8_t>(code);
    }
    clear();
  }

  void clear() { next_ = literals_ + 2; }

  /// The code of the next sequence; kMostCodes if there is no room.
  std::size_t next() const { return next_; }

  /// The first number of a sequence.
  std::uint8_t first(std::size_t code) const {
    while (code >= literals_) {
      code = before_[code];
    }
    return last_[code];
  }

  void add(std::size_t before, std::uint8_t last) {
    if (next_ < kMostCodes) {
      before_[next_] = before;
      last_[next_++] = last;
    }
  }

  void append(std::size_t code, std::vector<std::uint8_t>& numbers) const {
    const auto begin = static_cast<std::ptrdiff_t>(numbers.size());
    for (; code >= literals_; code = before_[code]) {
      numbers.push_back(last_[code]);
    }
    numbers.push_back(last_[code]);
    std::reverse(numbers.begin() + begin, numbers.end());
  }

 private:
  std::size_t literals_;
  std::vector<std::size_t> before_;
  std::vector<std::uint8_t> last_;
  std::size_t next_ = 0;
};

/// Unpacks the codes of LZW to `count` numbers of colours, or fewer if the codes are damaged.
std::vector<std::uint8_t> unpacked(const std::string& packed, unsigned bits_of_number,
                                   std::size_t count) {
  constexpr unsigned kWidest = 12;  // [bits]
  const std::size_t clear = std::size_t{1} << bits_of_number;
  Sequences sequences(clear);
  std::vector<std::uint8_t> numbers;
  unsigned width = bits_of_number + 1;
  constexpr std::size_t kNone = kMostCodes;
  std::size_t previous = kNone;
  std::size_t bits = 0;
  unsigned bit_count = 0;
  for (const char c : packed) {
    if (numbers.size() >= count) {
      break;  // what follows are the end, or damage
    }
    bits |= static_cast<std::size_t>(static_cast<unsigned char>(c)) << bit_count;
    bit_count += 8;
    while (bit_count >= width && numbers.size() < count) {
      const std::size_t code = bits & ((std::size_t{1} << width) - 1);
      bits >>= width;
      bit_count -= width;
      if (code == clear) {
        sequences.clear();
        width = bits_of_number + 1;
        previous = kNone;
        continue;
      }
      // The next code stands for the last sequence and its own first number.
      const bool is_next = previous != kNone && code == sequences.next();
      if (code == clear + 1 || (code >= sequences.next() && !is_next)) {
        return numbers;
      }
      if (previous != kNone) {
        sequences.add(previous, sequences.first(is_next ? previous : code));
      }
      sequences.append(code, numbers);
      previous = code;
      width += sequences.next() == (std::size_t{1} << width) && width < kWidest ? 1 : 0;
    }
  }
  return numbers;
}

/// The rows of a picture in the order in which they are stored.
std::vector<std::int64_t> rowsOf(std::int64_t height, bool is_interlaced) {
  std::vector<std::int64_t> rows;
  constexpr std::array<std::array<std::int64_t, 2>, 4> kPasses{{{0, 8}, {4, 8}, {2, 4}, {1, 2}}};
  for (const auto& [first, step] : kPasses) {
    for (std::int64_t row = is_interlaced ? first : 0; row < height;
         row += is_interlaced ? step : 1) {
      rows.push_back(row);
    }
    if (!is_interlaced) {
      break;
    }
  }
  return rows;
}

}  // namespace

bool isGif(std::string_view bytes) {
  return bytes.substr(0, 6) == "GIF87a" || bytes.substr(0, 6) == "GIF89a";
}

TranslucentImage decodeGif(std::string_view bytes, const std::string& file) {
  constexpr unsigned kHasPalette = 0x80, kInterlaced = 0x40, kHasTransparent = 1;
  constexpr std::uint8_t kExtension = 0x21, kControl = 0xf9, kPicture = 0x2c;
  GifBytes gif(bytes, file);
  gif.take(6);
  const std::int64_t width = gif.number();
  const std::int64_t height = gif.number();
  if (width * height == 0) {
    gif.refuse();
  }
  if (width * height > kMostPngPixels) {
    throw InputError(file + ": the picture must have 1 to " + std::to_string(kMostPngPixels) +
                     " pixels; scale it down");
  }
  const unsigned flags = gif.byte();
  gif.take(2);
  Palette palette = (flags & kHasPalette) != 0 ? takePalette(gif, flags) : Palette{};
  int transparent = -1;
  std::uint8_t kind = gif.byte();
  for (; kind == kExtension; kind = gif.byte()) {
    const bool is_control = gif.byte() == kControl;
    const std::string control = gif.blocks();
    if (is_control && control.size() >= 4 &&
        (static_cast<unsigned char>(control[0]) & kHasTransparent) != 0) {
      transparent = static_cast<unsigned char>(control[3]);
    }
  }
  if (kind != kPicture) {
    gif.refuse();
  }
  const std::int64_t left = gif.number();
  const std::int64_t top = gif.number();
  const std::int64_t columns = gif.number();
  const std::int64_t rows = gif.number();
  const unsigned picture_flags = gif.byte();
  palette = (picture_flags & kHasPalette) != 0 ? takePalette(gif, picture_flags) : palette;
  const unsigned first_width = gif.byte();
  if (first_width < 2 || first_width > 8 || left + columns > width || top + rows > height) {
    gif.refuse();
  }
  const auto count = static_cast<std::size_t>(columns * rows);
  const std::vector<std::uint8_t> numbers = unpacked(gif.blocks(), first_width, count);
  if (numbers.size() < count) {
    gif.refuse();
  }
  const auto pixels = static_cast<std::size_t>(width * height);
  TranslucentImage image{{width, height, std::vector<std::uint8_t>(pixels)},
                         std::vector<std::uint8_t>(pixels)};
  std::size_t from = 0;
  for (const std::int64_t row : rowsOf(rows, (picture_flags & kInterlaced) != 0)) {
    for (std::int64_t column = 0; column < columns; ++column, ++from) {
      const auto to = static_cast<std::size_t>((top + row) * width + left + column);
      image.grey.pixels[to] = palette[numbers[from]];
      image.opacity[to] = numbers[from] == transparent ? 0 : 255;
    }
  }
  return image;
}

}  // namespace sfw
