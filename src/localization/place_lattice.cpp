#include "localization/place_lattice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// Squared distance [m2] of each point of a grid to the nearest of some positions, up to a reach.
std::vector<double> squaresTo(const std::vector<Position>& mapped, const Position& origin,
                              double edge_m, int width, int height, double reach_m) {
  std::vector<double> squares(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                              std::numeric_limits<double>::infinity());
  const int reach = static_cast<int>(std::ceil(reach_m / edge_m));
  for (const Position& position : mapped) {
    const Position at = (position - origin) / edge_m;
    const int column = static_cast<int>(std::lround(at.x()));
    const int row = static_cast<int>(std::lround(at.y()));
    for (int y = std::max(row - reach, 0); y <= std::min(row + reach, height - 1); ++y) {
      for (int x = std::max(column - reach, 0); x <= std::min(column + reach, width - 1); ++x) {
        const Position point = origin + edge_m * Position(x, y);
        const double square = (point - position).squaredNorm();
        double& least = squares[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                static_cast<std::size_t>(x)];
        least = std::min(least, square);
      }
    }
  }
  return squares;
}

/// One position in each square, so that a robot that stood still costs no time.
std::vector<Position> thinned(std::vector<Position> positions, double edge_m) {
  const auto square = [&](const Position& position) {
    return std::make_pair(std::floor(position.y() / edge_m), std::floor(position.x() / edge_m));
  };
  std::stable_sort(positions.begin(), positions.end(),
                   [&](const Position& a, const Position& b) { return square(a) < square(b); });
  positions.erase(
      std::unique(positions.begin(), positions.end(),
                  [&](const Position& a, const Position& b) { return square(a) == square(b); }),
      positions.end());
  return positions;
}

}  // namespace

PlaceLattice::PlaceLattice(const std::vector<Position>& mapped, const Config& config) {
  constexpr double kThinningM = 0.25;
  const std::vector<Position> path = thinned(mapped, kThinningM);
  // Places within reach cover about this area: squares of the reach around each part of the path.
  const double area_m2 = static_cast<double>(thinned(path, config.reach_m).size()) *
                         config.reach_m * config.reach_m * 2.0;
  edge_m_ = std::max(std::clamp(std::sqrt(area_m2 / config.wanted_points), config.finest_edge_m,
                                config.coarsest_edge_m),
                     std::sqrt(area_m2 / config.most_points));
  Box box;
  for (const Position& position : path) {
    box.extend(position);
  }
  const Position margin(config.reach_m, config.reach_m);
  origin_ = box.min() - margin;
  const Position size = (box.sizes() + 2.0 * margin) / edge_m_;
  constexpr double kMostSquares = 2e7;
  if (!(size.prod() < kMostSquares)) {
    throw InputError("the mapped positions cover " + std::to_string(std::lround(box.sizes().x())) +
                     " x " + std::to_string(std::lround(box.sizes().y())) +
                     " m, too much for a radio map; remove stray positions");
  }
  width_ = static_cast<int>(std::ceil(size.x())) + 1;
  height_ = static_cast<int>(std::ceil(size.y())) + 1;
  addPoints(squaresTo(path, origin_, edge_m_, width_, height_, config.reach_m), config);
}

void PlaceLattice::addPoints(const std::vector<double>& squares, const Config& config) {
  numbers_.assign(squares.size(), -1);
  double sum = 0.0;
  for (int row = 0; row < height_; ++row) {
    for (int column = 0; column < width_; ++column) {
      const std::size_t cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                               static_cast<std::size_t>(column);
      if (squares[cell] > config.reach_m * config.reach_m) {
        continue;
      }
      numbers_[cell] = static_cast<int>(points_.size());
      points_.push_back(origin_ + edge_m_ * Position(column, row));
      log_prior_.push_back(-0.5 * squares[cell] / (config.deviation_m * config.deviation_m));
      sum += std::exp(log_prior_.back());
    }
  }
  for (double& log_prior : log_prior_) {
    log_prior -= std::log(sum);
  }
}

int PlaceLattice::numberAt(int column, int row) const {
  if (column < 0 || row < 0 || column >= width_ || row >= height_) {
    return -1;
  }
  return numbers_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                  static_cast<std::size_t>(column)];
}

int PlaceLattice::nearest(const Position& position) const {
  const Position at = (position - origin_) / edge_m_;
  if (!(at.x() > -1.0 && at.y() > -1.0 && at.x() < width_ && at.y() < height_)) {
    return -1;
  }
  const int column = static_cast<int>(std::floor(at.x()));
  const int row = static_cast<int>(std::floor(at.y()));
  int found = -1;
  double least = std::numeric_limits<double>::infinity();
  for (int y = row; y <= row + 1; ++y) {
    for (int x = column; x <= column + 1; ++x) {
      const double square = (Position(x, y) - at).squaredNorm();
      if (numberAt(x, y) >= 0 && square < least) {
        found = numberAt(x, y);
        least = square;
      }
    }
  }
  return found;
}

double PlaceLattice::interpolated(const std::vector<double>& values,
                                  const Position& position) const {
  constexpr double kOutside = -std::numeric_limits<double>::infinity();
  const Position at = (position - origin_) / edge_m_;
  if (!(at.x() > -1.0 && at.y() > -1.0 && at.x() < width_ && at.y() < height_)) {
    return kOutside;
  }
  const int column = static_cast<int>(std::floor(at.x()));
  const int row = static_cast<int>(std::floor(at.y()));
  const double right = at.x() - column;
  const double up = at.y() - row;
  double sum = 0.0;
  double weights = 0.0;
  for (int corner = 0; corner < 4; ++corner) {
    const int x = corner % 2;
    const int y = corner / 2;
    const int number = numberAt(column + x, row + y);
    if (number >= 0) {
      const double weight = (x == 1 ? right : 1.0 - right) * (y == 1 ? up : 1.0 - up);
      sum += weight * values[static_cast<std::size_t>(number)];
      weights += weight;
    }
  }
  return weights > 0.0 ? sum / weights : kOutside;
}

}  // namespace sfw
