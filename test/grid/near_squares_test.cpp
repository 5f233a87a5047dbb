#include "grid/near_squares.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "grid/distance_transform.h"

namespace sfw {
namespace {

Mask scattered(std::int64_t width, std::int64_t height, double share) {
  Mask mask(GridGeometry(0.1, {0.0, 0.0}, width, height));
  Random random(static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height), 1);
  for (std::uint8_t& cell : mask.cells) {
    cell = random.uniform() < share ? 1 : 0;
  }
  return mask;
}

TEST(NearSquares, AreThoseOfDistancesWithinTheReach) {
  for (const double share : {0.0, 0.003, 0.1, 1.0}) {
    for (const auto& [width, height] : {std::pair(1, 1), {1, 40}, {50, 1}, {33, 47}, {200, 150}}) {
      const Mask mask = scattered(width, height, share);
      const Grid<double> distance = distanceTransform(mask);
      for (const std::int64_t reach : {0, 1, 2, 12, 126}) {
        const Grid<std::int16_t> squares = nearSquares(mask, reach);
        for (std::size_t i = 0; i < mask.cells.size(); ++i) {
          const double square = std::round(distance.cells[i] * distance.cells[i]);
          const auto beyond = static_cast<double>((reach + 1) * (reach + 1));
          ASSERT_EQ(squares.cells[i],
                    square < beyond ? static_cast<std::int16_t>(square) : kBeyondReach)
              << width << " x " << height << ", reach " << reach;
        }
      }
    }
  }
}

}  // namespace
}  // namespace sfw
