#include "walls/layers.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "base/random.h"

namespace sfw::test {
namespace {

using Values = std::vector<float>;

Channels channelsOf(std::size_t count, std::size_t height, std::size_t width, Values values) {
  Channels channels(count, height, width);
  channels.values() = std::move(values);
  return channels;
}

TEST(Layers, AConvolutionWeighsTheSquareAroundEachCell) {
  const Channels input = channelsOf(1, 3, 3, {1, 2, 3, 4, 5, 6, 7, 8, 9});
  const Convolution right_neighbour{1, 1, 3, {0, 0, 0, 0, 0, 1, 0, 0, 0}, {0}};
  EXPECT_EQ(convolve(rowsOf(input), right_neighbour, Activation::kNone).values(),
            (Values{2, 3, 0, 5, 6, 0, 8, 9, 0}));
  const Convolution sum{1, 1, 3, Values(9, 1.0F), {100}};
  EXPECT_EQ(convolve(rowsOf(input), sum, Activation::kNone).values(),
            (Values{112, 121, 116, 127, 145, 133, 124, 139, 128}));
}

TEST(Layers, AConvolutionOfOneCellMixesChannels) {
  const Channels input = channelsOf(2, 1, 2, {1, 2, 10, 20});
  const Convolution mix{2, 2, 1, {1, 1, 1, -1}, {0.5F, 0}};
  EXPECT_EQ(convolve(rowsOf(input), mix, Activation::kNone).values(),
            (Values{11.5F, 22.5F, -9, -18}));
  EXPECT_EQ(convolve(rowsOf(input), mix, Activation::kRelu).values(), (Values{11.5F, 22.5F, 0, 0}));
}

TEST(Layers, AConvolutionNeedsItsNumberOfChannels) {
  const Convolution one{1, 1, 1, {1}, {0}};
  const Channels two(2, 1, 1);
  EXPECT_THROW(convolve(rowsOf(two), one, Activation::kNone), std::invalid_argument);
}

/// A convolution of whole rasters, in the order that convolve promises.
Channels plainlyConvolved(const Channels& input, const Convolution& convolution) {
  const auto reach = static_cast<std::ptrdiff_t>(convolution.edge / 2);
  Channels result(convolution.outputs, input.height(), input.width());
  const auto at = [&](std::size_t c, std::ptrdiff_t y, std::ptrdiff_t x) {
    const bool inside = y >= 0 && y < static_cast<std::ptrdiff_t>(input.height()) && x >= 0 &&
                        x < static_cast<std::ptrdiff_t>(input.width());
    return inside ? input.row(c, static_cast<std::size_t>(y))[x] : 0.0F;
  };
  for (std::size_t o = 0; o < convolution.outputs; ++o) {
    for (std::size_t y = 0; y < input.height(); ++y) {
      for (std::size_t x = 0; x < input.width(); ++x) {
        float sum = convolution.bias[o];
        for (std::size_t c = 0; c < input.count(); ++c) {
          const float* k = convolution.weights.data() +
                           (o * input.count() + c) * convolution.edge * convolution.edge;
          float part = 0.0F;
          for (std::ptrdiff_t dy = -reach; dy <= reach; ++dy) {
            for (std::ptrdiff_t dx = -reach; dx <= reach; ++dx) {
              const float term = *k++ * at(c, static_cast<std::ptrdiff_t>(y) + dy,
                                           static_cast<std::ptrdiff_t>(x) + dx);
              part = dy == -reach && dx == -reach ? term : part + term;
            }
          }
          sum += part;
        }
        result.row(o, y)[x] = sum;
      }
    }
  }
  return result;
}

Channels noise(std::size_t count, std::size_t height, std::size_t width) {
  Channels channels(count, height, width);
  Random random(1, 2, 3);
  for (float& value : channels.values()) {
    value = static_cast<float>(random.normal());
  }
  return channels;
}

TEST(Layers, AConvolutionRowByRowHasTheBytesOfAPlainOne) {
  for (const std::size_t edge : {1U, 3U}) {
    for (const std::size_t height : {1U, 2U, 7U}) {
      const Channels input = noise(5, height, 19);
      const Channels weights = noise(5 * edge * edge, 4, 1);
      const Convolution convolution{5, 4, edge, weights.values(), {0.1F, 0, -2, 3}};
      EXPECT_EQ(convolve(rowsOf(input), convolution, Activation::kNone).values(),
                plainlyConvolved(input, convolution).values());
    }
  }
}

TEST(RowSource, PoolingTakesTheLargestOfFour) {
  const Channels input = channelsOf(1, 2, 4, {1, 9, 2, 3, 4, 5, -6, 1});
  EXPECT_EQ(channelsOf(maxPooled(input)).values(), (Values{9, 3}));
}

TEST(RowSource, UpsamplingRepeatsEachCellInASquare) {
  const Channels input = channelsOf(1, 1, 2, {3, 4});
  EXPECT_EQ(channelsOf(upsampled(input)).values(), (Values{3, 3, 4, 4, 3, 3, 4, 4}));
}

TEST(RowSource, JoiningKeepsTheFirstChannelsFirst) {
  const Channels first = channelsOf(1, 2, 2, {1, 2, 7, 8});
  const Channels second = channelsOf(2, 2, 2, {3, 4, 5, 6, 10, 20, 30, 40});
  const Channels both = channelsOf(joined(rowsOf(first), rowsOf(second)));
  EXPECT_EQ(both.count(), 3U);
  EXPECT_EQ(both.values(), (Values{1, 2, 7, 8, 3, 4, 5, 6, 10, 20, 30, 40}));
  const Channels other(1, 2, 1);
  EXPECT_THROW(joined(rowsOf(first), rowsOf(other)), std::invalid_argument);
}

TEST(RowSource, PaddingPutsZerosBehindRowsAndAboveThem) {
  const Channels input = channelsOf(2, 1, 2, {1, 2, 3, 4});
  EXPECT_EQ(channelsOf(padded(rowsOf(input), 2, 3)).values(),
            (Values{1, 2, 0, 0, 0, 0, 3, 4, 0, 0, 0, 0}));
}

}  // namespace
}  // namespace sfw::test
