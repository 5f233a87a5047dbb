#include "grid/near_squares.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/function_versions.h"

namespace sfw {
namespace {

using Square = std::int16_t;

/// Distances to the nearest set cell in each column, from one row to the next one.
/// @param beyond  at least as long as any that matters
/// @param from    distances of the row before
SFW_FUNCTION_VERSIONS
void step(const std::uint8_t* mask, const Square* from, Square beyond, std::size_t width,
          Square* to) {
  for (std::size_t x = 0; x < width; ++x) {
    const auto next = static_cast<Square>(from[x] + 1);
    const Square least = std::min(std::min(next, beyond), to[x]);
    to[x] = mask[x] != 0 ? Square{0} : least;
  }
}

/// The least of the squares of a row and its distances along the row.
/// @param squares  of the distances in each column; `reach` more on both sides
SFW_FUNCTION_VERSIONS
void leastSquares(const Square* squares, Square reach, std::size_t width, Square* to) {
  std::copy_n(squares, width, to);
  for (Square i = 1; i <= reach; ++i) {
    const auto square = static_cast<Square>(i * i);
    for (std::size_t x = 0; x < width; ++x) {
      const Square beside = std::min(squares[x - static_cast<std::size_t>(i)],
                                     squares[x + static_cast<std::size_t>(i)]);
      to[x] = std::min(to[x], static_cast<Square>(beside + square));
    }
  }
  const auto beyond = static_cast<Square>((reach + 1) * (reach + 1));
  for (std::size_t x = 0; x < width; ++x) {
    to[x] = to[x] < beyond ? to[x] : kBeyondReach;
  }
}

}  // namespace

Grid<std::int16_t> nearSquares(const Mask& mask, std::int64_t reach) {
  const auto beyond = static_cast<Square>(reach + 1);
  const auto width = static_cast<std::size_t>(mask.geometry.width());
  const auto height = static_cast<std::size_t>(mask.geometry.height());
  Grid<Square> result(mask.geometry, beyond);
  Square* const cells = result.cells.data();
  const std::vector<Square> none(width, beyond);
  for (std::size_t y = 0; y < height; ++y) {
    step(mask.cells.data() + y * width, y == 0 ? none.data() : cells + (y - 1) * width, beyond,
         width, cells + y * width);
  }
  for (std::size_t y = height - 1; y-- > 0;) {
    step(mask.cells.data() + y * width, cells + (y + 1) * width, beyond, width, cells + y * width);
  }
  const auto margin = static_cast<std::size_t>(reach);
  std::vector<Square> squares(width + 2 * margin, static_cast<Square>(beyond * beyond));
  for (std::size_t y = 0; y < height; ++y) {
    Square* const row = cells + y * width;
    std::transform(row, row + width, squares.begin() + static_cast<std::ptrdiff_t>(margin),
                   [](Square distance) { return static_cast<Square>(distance * distance); });
    leastSquares(squares.data() + margin, static_cast<Square>(reach), width, row);
  }
  return result;
}

}  // namespace sfw
