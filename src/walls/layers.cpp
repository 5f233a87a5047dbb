#include "walls/layers.h"

#include <algorithm>
#include <stdexcept>

#include "base/function_versions.h"

namespace sfw {
namespace {

/// Surrounds every raster with zeros.
Channels withBorder(const Channels& input) {
  Channels result(input.count(), input.height() + 2, input.width() + 2);
  for (std::size_t c = 0; c < input.count(); ++c) {
    for (std::size_t y = 0; y < input.height(); ++y) {
      std::copy_n(input.row(c, y), input.width(), result.row(c, y + 1) + 1);
    }
  }
  return result;
}

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

Channels convolve(const Channels& input, const Convolution& convolution, Activation activation) {
  if (input.count() != convolution.inputs) {
    throw std::invalid_argument("a convolution got another number of channels than it has weights");
  }
  const bool square = convolution.edge == 3;
  const Channels from = square ? withBorder(input) : input;
  const std::size_t kernel = convolution.edge * convolution.edge;
  Channels result(convolution.outputs, input.height(), input.width());
  for (std::size_t o = 0; o < convolution.outputs; ++o) {
    for (std::size_t y = 0; y < input.height(); ++y) {
      float* to = result.row(o, y);
      std::fill_n(to, input.width(), convolution.bias[o]);
      for (std::size_t c = 0; c < input.count(); ++c) {
        const float* k = convolution.weights.data() + (o * input.count() + c) * kernel;
        if (square) {
          addSquare(from.row(c, y), from.row(c, y + 1), from.row(c, y + 2), k, input.width(), to);
        } else {
          addPoint(from.row(c, y), *k, input.width(), to);
        }
      }
    }
  }
  if (activation == Activation::kRelu) {
    for (float& value : result.values()) {
      value = std::max(value, 0.0F);
    }
  }
  return result;
}

Channels maxPool(const Channels& input) {
  Channels result(input.count(), input.height() / 2, input.width() / 2);
  for (std::size_t c = 0; c < result.count(); ++c) {
    for (std::size_t y = 0; y < result.height(); ++y) {
      const float* upper = input.row(c, 2 * y);
      const float* lower = input.row(c, 2 * y + 1);
      float* to = result.row(c, y);
      for (std::size_t x = 0; x < result.width(); ++x) {
        to[x] = std::max(std::max(upper[2 * x], upper[2 * x + 1]),
                         std::max(lower[2 * x], lower[2 * x + 1]));
      }
    }
  }
  return result;
}

Channels upsample(const Channels& input) {
  Channels result(input.count(), 2 * input.height(), 2 * input.width());
  for (std::size_t c = 0; c < result.count(); ++c) {
    for (std::size_t y = 0; y < result.height(); ++y) {
      const float* from = input.row(c, y / 2);
      float* to = result.row(c, y);
      for (std::size_t x = 0; x < result.width(); ++x) {
        to[x] = from[x / 2];
      }
    }
  }
  return result;
}

Channels joined(const Channels& first, const Channels& second) {
  if (first.height() != second.height() || first.width() != second.width()) {
    throw std::invalid_argument("only rasters of equal size can be joined");
  }
  Channels result(first.count() + second.count(), first.height(), first.width());
  std::copy(first.values().begin(), first.values().end(), result.values().begin());
  std::copy(second.values().begin(), second.values().end(),
            result.values().begin() + static_cast<std::ptrdiff_t>(first.values().size()));
  return result;
}

}  // namespace sfw
