#pragma once

#include <cstddef>
#include <vector>

namespace sfw {

/// Rasters of equal size: the values of a network between two layers. Rows lie one after another,
/// channel by channel.
class Channels {
 public:
  Channels() = default;

  /// All values are 0.
  Channels(std::size_t count, std::size_t height, std::size_t width)
      : count_(count), height_(height), width_(width), values_(count * height * width) {}

  std::size_t count() const { return count_; }
  std::size_t height() const { return height_; }
  std::size_t width() const { return width_; }

  float* row(std::size_t channel, std::size_t y) {
    return values_.data() + (channel * height_ + y) * width_;
  }
  const float* row(std::size_t channel, std::size_t y) const {
    return values_.data() + (channel * height_ + y) * width_;
  }

  std::vector<float>& values() { return values_; }
  const std::vector<float>& values() const { return values_; }

 private:
  std::size_t count_ = 0;
  std::size_t height_ = 0;
  std::size_t width_ = 0;
  std::vector<float> values_;
};

}  // namespace sfw
