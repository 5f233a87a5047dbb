#include "walls/layers.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

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
  EXPECT_EQ(convolve(input, right_neighbour, Activation::kNone).values(),
            (Values{2, 3, 0, 5, 6, 0, 8, 9, 0}));
  const Convolution sum{1, 1, 3, Values(9, 1.0F), {100}};
  EXPECT_EQ(convolve(input, sum, Activation::kNone).values(),
            (Values{112, 121, 116, 127, 145, 133, 124, 139, 128}));
}

TEST(Layers, AConvolutionOfOneCellMixesChannels) {
  const Channels input = channelsOf(2, 1, 2, {1, 2, 10, 20});
  const Convolution mix{2, 2, 1, {1, 1, 1, -1}, {0.5F, 0}};
  EXPECT_EQ(convolve(input, mix, Activation::kNone).values(), (Values{11.5F, 22.5F, -9, -18}));
  EXPECT_EQ(convolve(input, mix, Activation::kRelu).values(), (Values{11.5F, 22.5F, 0, 0}));
}

TEST(Layers, AConvolutionNeedsItsNumberOfChannels) {
  const Convolution one{1, 1, 1, {1}, {0}};
  EXPECT_THROW(convolve(Channels(2, 1, 1), one, Activation::kNone), std::invalid_argument);
}

TEST(Layers, PoolingTakesTheLargestOfFour) {
  const Channels input = channelsOf(1, 2, 4, {1, 9, 2, 3, 4, 5, -6, 1});
  EXPECT_EQ(maxPool(input).values(), (Values{9, 3}));
}

TEST(Layers, UpsamplingRepeatsEachCellInASquare) {
  const Channels input = channelsOf(1, 1, 2, {3, 4});
  EXPECT_EQ(upsample(input).values(), (Values{3, 3, 4, 4, 3, 3, 4, 4}));
}

TEST(Layers, JoiningKeepsTheFirstChannelsFirst) {
  const Channels both = joined(channelsOf(1, 1, 2, {1, 2}), channelsOf(2, 1, 2, {3, 4, 5, 6}));
  EXPECT_EQ(both.count(), 3U);
  EXPECT_EQ(both.values(), (Values{1, 2, 3, 4, 5, 6}));
  EXPECT_THROW(joined(Channels(1, 1, 2), Channels(1, 2, 1)), std::invalid_argument);
}

}  // namespace
}  // namespace sfw::test
