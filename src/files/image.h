#pragma once

#include <string>

#include "files/png.h"

namespace sfw {

/// Reads an image in any format that map_server reads: PGM, PNG, GIF, BMP, JPEG and others, by
/// their content. The grey of a colour is the mean of its channels, as map_server takes it.
/// @throw InputError naming the file and what to do if it cannot be read, is damaged, or has a
/// format that is not known
TranslucentImage readImage(const std::string& file);

}  // namespace sfw
