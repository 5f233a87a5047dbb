#include "walls/row_source.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace sfw {

RowSource rowsOf(const Channels& rasters) {
  return {rasters.count(), rasters.height(), rasters.width(),
          [&rasters](std::size_t y, float* to, std::size_t stride) {
            for (std::size_t c = 0; c < rasters.count(); ++c, to += stride) {
              std::copy_n(rasters.row(c, y), rasters.width(), to);
            }
          }};
}

RowSource padded(RowSource input, std::size_t height, std::size_t width) {
  return {input.count, height, width,
          [input = std::move(input), width](std::size_t y, float* to, std::size_t stride) {
            if (y < input.height) {
              input.write(y, to, stride);
            }
            const std::size_t inside = y < input.height ? input.width : 0;
            for (std::size_t c = 0; c < input.count; ++c, to += stride) {
              std::fill(to + inside, to + width, 0.0F);
            }
          }};
}

RowSource maxPooled(const Channels& rasters) {
  return {rasters.count(), rasters.height() / 2, rasters.width() / 2,
          [&rasters](std::size_t y, float* to, std::size_t stride) {
            for (std::size_t c = 0; c < rasters.count(); ++c, to += stride) {
              const float* const one = rasters.row(c, 2 * y);
              const float* const next = rasters.row(c, 2 * y + 1);
              for (std::size_t x = 0; x < rasters.width() / 2; ++x) {
                to[x] = std::max(std::max(one[2 * x], one[2 * x + 1]),
                                 std::max(next[2 * x], next[2 * x + 1]));
              }
            }
          }};
}

RowSource upsampled(const Channels& rasters) {
  return {rasters.count(), 2 * rasters.height(), 2 * rasters.width(),
          [&rasters](std::size_t y, float* to, std::size_t stride) {
            for (std::size_t c = 0; c < rasters.count(); ++c, to += stride) {
              const float* const from = rasters.row(c, y / 2);
              for (std::size_t x = 0; x < rasters.width(); ++x) {
                to[2 * x] = from[x];
                to[2 * x + 1] = from[x];
              }
            }
          }};
}

RowSource joined(RowSource first, RowSource second) {
  if (first.height != second.height || first.width != second.width) {
    throw std::invalid_argument("only rasters of equal size can be joined");
  }
  const std::size_t count = first.count + second.count;
  const std::size_t height = first.height;
  const std::size_t width = first.width;
  return {count, height, width,
          [first = std::move(first), second = std::move(second)](std::size_t y, float* to,
                                                                 std::size_t stride) {
            first.write(y, to, stride);
            second.write(y, to + first.count * stride, stride);
          }};
}

Channels channelsOf(const RowSource& rows) {
  Channels rasters(rows.count, rows.height, rows.width);
  for (std::size_t y = 0; y < rows.height; ++y) {
    rows.write(y, rasters.row(0, y), rows.height * rows.width);
  }
  return rasters;
}

}  // namespace sfw
