#include "structure_from_wifi/shadowing.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace sfw {
namespace {

/// With 12 the product with the true covariance differs from the identity by less than shadowing's
/// own uncertainty.
constexpr std::size_t kNeighbours = 12;

/// Places in an order in which each finds neighbours on all sides among those before it: coarse
/// to fine, by the bits of its number in reverse.
std::vector<int> coarseToFine(std::size_t count) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  const auto reversed = [](int number) {
    auto bits = static_cast<std::uint32_t>(number);
    std::uint32_t result = 0;
    for (int i = 0; i < 32; ++i, bits >>= 1U) {
      result = (result << 1U) | (bits & 1U);
    }
    return result;
  };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return reversed(a) < reversed(b); });
  return order;
}

/// The nearest of the places before `rank` in the order.
std::vector<int> neighboursOf(const std::vector<Position>& places, const std::vector<int>& order,
                              std::size_t rank) {
  const Position& place = places[static_cast<std::size_t>(order[rank])];
  std::vector<std::pair<double, int>> candidates;
  candidates.reserve(rank);
  for (std::size_t i = 0; i < rank; ++i) {
    const int other = order[i];
    candidates.emplace_back((places[static_cast<std::size_t>(other)] - place).squaredNorm(), other);
  }
  const std::size_t count = std::min(kNeighbours, candidates.size());
  std::partial_sort(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(count),
                    candidates.end());
  std::vector<int> neighbours;
  for (std::size_t i = 0; i < count; ++i) {
    neighbours.push_back(candidates[i].second);
  }
  return neighbours;
}

}  // namespace

ShadowingWhitener::ShadowingWhitener(const std::vector<Position>& places,
                                     const std::vector<double>& noise_db2,
                                     const ShadowingModel& model) {
  const std::size_t count = places.size();
  const double variance = model.shadowing_db * model.shadowing_db;
  const auto covariance = [&](int a, int b) {
    const double distance =
        (places[static_cast<std::size_t>(a)] - places[static_cast<std::size_t>(b)]).norm();
    const double own =
        a == b ? noise_db2[static_cast<std::size_t>(a)] + model.unexplained_db2 : 0.0;
    return variance * std::exp(-distance / model.shadowing_distance) + own;
  };
  const std::vector<int> order = coarseToFine(count);
  row_begin_.push_back(0);
  for (std::size_t rank = 0; rank < count; ++rank) {
    const int place = order[rank];
    const std::vector<int> neighbours = neighboursOf(places, order, rank);
    const auto size = static_cast<Eigen::Index>(neighbours.size());
    Eigen::MatrixXd among(size, size);
    Eigen::VectorXd with(size);
    for (Eigen::Index i = 0; i < size; ++i) {
      const int a = neighbours[static_cast<std::size_t>(i)];
      with[i] = covariance(a, place);
      for (Eigen::Index j = 0; j < size; ++j) {
        among(i, j) = covariance(a, neighbours[static_cast<std::size_t>(j)]);
      }
    }
    const Eigen::VectorXd weight = size > 0 ? Eigen::VectorXd(among.ldlt().solve(with)) : with;
    const double scale = 1.0 / std::sqrt(covariance(place, place) - weight.dot(with));
    entries_.push_back({place, scale});
    for (Eigen::Index i = 0; i < size; ++i) {
      entries_.push_back({neighbours[static_cast<std::size_t>(i)], -scale * weight[i]});
    }
    row_begin_.push_back(static_cast<int>(entries_.size()));
  }
}

Eigen::VectorXd ShadowingWhitener::whitened(const Eigen::VectorXd& values) const {
  Eigen::VectorXd white = Eigen::VectorXd::Zero(values.size());
  for (std::size_t row = 0; row + 1 < row_begin_.size(); ++row) {
    for (int i = row_begin_[row]; i < row_begin_[row + 1]; ++i) {
      const Entry& entry = entries_[static_cast<std::size_t>(i)];
      white[static_cast<Eigen::Index>(row)] += entry.value * values[entry.column];
    }
  }
  return white;
}

Eigen::VectorXd ShadowingWhitener::whitenedTwice(const Eigen::VectorXd& values) const {
  const Eigen::VectorXd white = whitened(values);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(values.size());
  for (std::size_t row = 0; row + 1 < row_begin_.size(); ++row) {
    for (int i = row_begin_[row]; i < row_begin_[row + 1]; ++i) {
      const Entry& entry = entries_[static_cast<std::size_t>(i)];
      result[entry.column] += entry.value * white[static_cast<Eigen::Index>(row)];
    }
  }
  return result;
}

SignalPrecision::SignalPrecision(const std::vector<Position>& places,
                                 const std::vector<double>& noise_db2,
                                 const std::vector<double>& loss_db, const ShadowingModel& model)
    : whitener_(places, noise_db2, model) {
  const auto count = static_cast<Eigen::Index>(places.size());
  Eigen::MatrixXd basis(count, 2);
  solved_basis_.resize(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    basis.row(i) << model.power_db, model.exponent * loss_db[static_cast<std::size_t>(i)];
  }
  for (Eigen::Index column = 0; column < 2; ++column) {
    solved_basis_.col(column) = whitener_.whitenedTwice(basis.col(column));
  }
  capacitance_ = (Eigen::Matrix2d::Identity() + basis.transpose() * solved_basis_).inverse();
}

Eigen::VectorXd SignalPrecision::times(const Eigen::VectorXd& residual) const {
  return whitener_.whitenedTwice(residual) -
         solved_basis_ * (capacitance_ * (solved_basis_.transpose() * residual));
}

}  // namespace sfw
