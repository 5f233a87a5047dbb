#include "walls/layers.h"

#include <algorithm>
#include <stdexcept>

#include "base/function_versions.h"

namespace sfw {
namespace {

/// Three rows of each channel: those around one row of the result, with zeros around the raster.
/// They stay in the cache while all outputs of the row are calculated.
class RowsAround {
 public:
  explicit RowsAround(const RowSource& input)
      : input_(input), rows_(input.count, kRows, input.width + 2) {
    load(0);
  }

  /// Moves on to a row; rows come one by one from 0.
  void moveTo(std::size_t y) {
    y_ = y;
    load(y + 1);
  }

  const float* above(std::size_t channel) const { return at(channel, y_ + kRows - 1); }
  const float* here(std::size_t channel) const { return at(channel, y_); }
  const float* below(std::size_t channel) const { return at(channel, y_ + 1); }

 private:
  static constexpr std::size_t kRows = 3;

  void load(std::size_t y) {
    float* const to = rows_.row(0, y % kRows) + 1;
    const std::size_t stride = kRows * rows_.width();
    if (y < input_.height) {
      input_.write(y, to, stride);
      return;
    }
    for (std::size_t c = 0; c < input_.count; ++c) {
      std::fill_n(to + c * stride, input_.width, 0.0F);
    }
  }

  const float* at(std::size_t channel, std::size_t y) const {
    return rows_.row(channel, y % kRows);
  }

  const RowSource& input_;
  Channels rows_;  // row y of the input, modulo kRows
  std::size_t y_ = 0;
};

/// Adds a row of one channel, weighted by a kernel of one cell.
SFW_FUNCTION_VERSIONS
void addPoint(const float* from, float weight, std::size_t width, float* to) {
  for (std::size_t x = 0; x < width; ++x) {
    to[x] += weight * from[x];
  }
}

/// Adds three rows of one channel, weighted by a kernel of three by three cells.
SFW_FUNCTION_VERSIONS
void addSquare(const float* above, const float* here, const float* below, const float* k,
               std::size_t width, float* to) {
  for (std::size_t x = 0; x < width; ++x) {
    to[x] += k[0] * above[x] + k[1] * above[x + 1] + k[2] * above[x + 2] +  //
             k[3] * here[x] + k[4] * here[x + 1] + k[5] * here[x + 2] +     //
             k[6] * below[x] + k[7] * below[x + 1] + k[8] * below[x + 2];
  }
}

}  // namespace

Channels convolve(const RowSource& input, const Convolution& convolution, Activation activation) {
  if (input.count != convolution.inputs) {
    throw std::invalid_argument("a convolution got another number of channels than it has weights");
  }
  const bool square = convolution.edge == 3;
  const std::size_t kernel = convolution.edge * convolution.edge;
  Channels result(convolution.outputs, input.height, input.width);
  RowsAround rows(input);
  for (std::size_t y = 0; y < input.height; ++y) {
    rows.moveTo(y);
    const float* k = convolution.weights.data();
    for (std::size_t o = 0; o < convolution.outputs; ++o) {
      float* to = result.row(o, y);
      std::fill_n(to, input.width, convolution.bias[o]);
      for (std::size_t c = 0; c < input.count; ++c, k += kernel) {
        if (square) {
          addSquare(rows.above(c), rows.here(c), rows.below(c), k, input.width, to);
        } else {
          addPoint(rows.here(c) + 1, *k, input.width, to);
        }
      }
      if (activation == Activation::kRelu) {
        std::transform(to, to + input.width, to, [](float value) { return std::max(value, 0.0F); });
      }
    }
  }
  return result;
}

}  // namespace sfw
