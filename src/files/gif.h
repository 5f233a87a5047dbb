#pragma once

#include <string>
#include <string_view>

#include "files/png.h"

namespace sfw {

/// Whether bytes begin with the signature of a GIF.
bool isGif(std::string_view bytes);

/// Decodes the first picture of a GIF. The grey of a colour is the mean of its channels. Pixels
/// beside the picture are transparent.
/// @param file  its name, for the error
/// @throw InputError if it is damaged or cut short, or has more than kMostPngPixels pixels. The
/// size is checked before any allocation for the pixels.
TranslucentImage decodeGif(std::string_view bytes, const std::string& file);

}  // namespace sfw
