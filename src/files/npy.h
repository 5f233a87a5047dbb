#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace sfw {

/// The bytes of a NumPy file (format 1.0, little endian, single precision) of a 3-D array.
/// @param shape   sizes of the axes, the slowest one first
/// @param values  as many as the shape has, the last axis fastest
/// @throw std::invalid_argument if the number of values does not fit the shape.
std::string npyOf(const std::array<std::size_t, 3>& shape, const std::vector<float>& values);

}  // namespace sfw
