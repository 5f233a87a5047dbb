#include "files/pgm.h"

#include <algorithm>
#include <cctype>

#include "files/text.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// Walks over the parts of a PGM's header and, for P2, its pixels.
class PgmText {
 public:
  PgmText(const std::string& file, const std::string& bytes) : file_(file), bytes_(bytes) {}

  std::string magic() {
    at_ = 2;
    return bytes_.substr(0, 2);
  }

  long number(long low, long high) {
    skipBlanksAndComments();
    long value = 0;
    const std::size_t start = at_;
    while (at_ < bytes_.size() && std::isdigit(static_cast<unsigned char>(bytes_[at_])) != 0) {
      value = value * 10 + (bytes_[at_++] - '0');
      if (value > high) {
        break;
      }
    }
    if (at_ == start || value < low || value > high) {
      throw InputError(file_ + ": not a whole PGM (byte " + std::to_string(start) + ")");
    }
    return value;
  }

  /// The start of the pixels of a P5: after exactly one blank.
  std::size_t pixels() const { return at_ + 1; }

 private:
  void skipBlanksAndComments() {
    while (at_ < bytes_.size()) {
      if (bytes_[at_] == '#') {
        at_ = std::min(bytes_.find('\n', at_), bytes_.size());
      } else if (std::isspace(static_cast<unsigned char>(bytes_[at_])) == 0) {
        return;
      } else {
        ++at_;
      }
    }
  }

  const std::string& file_;
  const std::string& bytes_;
  std::size_t at_ = 0;
};

}  // namespace

GreyImage readPgm(const std::string& file) {
  const std::string bytes = readFile(file);
  PgmText text(file, bytes);
  const std::string magic = text.magic();
  if (magic != "P5" && magic != "P2") {
    throw InputError(file + ": not a PGM image (P2 or P5); convert it, e.g. with ImageMagick");
  }
  constexpr long kMaxSide = 1L << 18;
  GreyImage image;
  image.width = text.number(1, kMaxSide);
  image.height = text.number(1, kMaxSide);
  constexpr long kDeepest = 65535;
  const long deepest = text.number(1, kDeepest);
  const std::size_t width = magic == "P5" && deepest > 255 ? 2 : 1;  // bytes of a value
  const auto count = static_cast<std::size_t>(image.width * image.height);
  // Checked before any allocation: each pixel takes at least a byte of the file.
  if (bytes.size() < width * count) {
    throw InputError(file + ": the image is cut short");
  }
  image.pixels.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    long value = 0;
    if (magic == "P2") {
      value = text.number(0, deepest);
    } else if (text.pixels() + width * (i + 1) <= bytes.size()) {
      for (std::size_t at = text.pixels() + width * i; at < text.pixels() + width * (i + 1); ++at) {
        value = value << 8 | static_cast<std::uint8_t>(bytes[at]);
      }
    } else {
      throw InputError(file + ": the image is cut short");
    }
    // P5 can hold values that its own header excludes.
    image.pixels[i] = static_cast<std::uint8_t>(std::min(value, deepest) * 255 / deepest);
  }
  return image;
}

}  // namespace sfw
