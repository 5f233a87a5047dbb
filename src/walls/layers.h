#pragma once

#include <cstddef>
#include <vector>

#include "walls/channels.h"
#include "walls/row_source.h"

namespace sfw {

/// A convolution with a bias for each output channel. The size of the rasters stays, as zeros
/// surround them.
struct Convolution {
  std::size_t inputs = 0;
  std::size_t outputs = 0;
  std::size_t edge = 1;        ///< of the kernel in cells: 1 or 3
  std::vector<float> weights;  ///< by output, input, row and column of the kernel
  std::vector<float> bias;     ///< of each output
};

enum class Activation { kNone, kRelu };

/// Applies a convolution, and sets negative results to 0 if the activation says so.
///
/// The order of additions is fixed, so equal inputs give equal bytes on processors that round each
/// operation.
/// @throw std::invalid_argument if the input has another number of channels.
/// O(cells x weights).
Channels convolve(const RowSource& input, const Convolution& convolution, Activation activation);

}  // namespace sfw
