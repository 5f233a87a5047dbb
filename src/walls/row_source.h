#pragma once

#include <cstddef>
#include <functional>

#include "walls/channels.h"

namespace sfw {

/// Rasters whose rows are made when a layer needs them. So they need not fit the memory, and their
/// rows are still in the cache when they are used.
struct RowSource {
  std::size_t count = 0;  ///< channels
  std::size_t height = 0;
  std::size_t width = 0;

  /// Writes one row of each channel. Rows come one by one from 0.
  /// @param to      first value of the first channel
  /// @param stride  from channel to channel
  std::function<void(std::size_t y, float* to, std::size_t stride)> write;
};

/// The rows of rasters, which must outlive the result.
RowSource rowsOf(const Channels& rasters);

/// Rows of larger rasters: zeros lie behind those of the input, to the right and above.
RowSource padded(RowSource input, std::size_t height, std::size_t width);

/// The largest value of each square of two by two cells. Height and width must be even.
/// @param rasters  must outlive the result, as for upsampled
RowSource maxPooled(const Channels& rasters);

/// Repeats each cell in a square of two by two cells.
RowSource upsampled(const Channels& rasters);

/// The channels of both, the first ones first.
/// @throw std::invalid_argument if their sizes differ.
RowSource joined(RowSource first, RowSource second);

/// All rows.
Channels channelsOf(const RowSource& rows);

}  // namespace sfw
