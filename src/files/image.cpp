#include "files/image.h"

#include "files/gif.h"
#include "files/mrpt_library.h"
#include "files/pgm.h"
#include "files/text.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

TranslucentImage readByOpenCv(const std::string& file) {
  TranslucentImage image = mrptFunctions().readImage(file);
  if (image.grey.pixels.empty()) {
    throw InputError(file + ": the image is damaged, or its format is not known; convert it to " +
                     "PNG, such as with ImageMagick: convert " + file + " map.png");
  }
  return image;
}

}  // namespace

TranslucentImage readImage(const std::string& file) {
  const std::string bytes = readFile(file);
  if (isPng(bytes)) {
    return readPng(file, GreyOf::kMean);
  }
  if (isGif(bytes)) {
    return decodeGif(bytes, file);
  }
  const std::string magic = bytes.substr(0, 2);
  if (magic == "P2" || magic == "P5") {
    return {readPgm(file), {}};
  }
  return readByOpenCv(file);
}

}  // namespace sfw
