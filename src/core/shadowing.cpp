#include "structure_from_wifi/shadowing.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "nearest_places.h"

namespace sfw {
namespace {

/// With 12 the variance of most sums of signals is right within a seventh, and of the worst one
/// within a half: far less than what is known of shadowing.
constexpr int kNeighbours = 12;

/// Places in an order in which each finds neighbours on all sides among those before it: coarse
/// to fine, by the bits of its number in reverse.
std::vector<int> coarseToFine(std::size_t count) {
  std::vector<std::pair<std::uint32_t, int>> keyed(count);
  for (std::size_t i = 0; i < count; ++i) {
    auto bits = static_cast<std::uint32_t>(i);
    std::uint32_t reversed = 0;
    for (int bit = 0; bit < 32; ++bit, bits >>= 1U) {
      reversed = (reversed << 1U) | (bits & 1U);
    }
    keyed[i] = {reversed, static_cast<int>(i)};
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<int> order;
  order.reserve(count);
  for (const auto& [key, number] : keyed) {
    order.push_back(number);
  }
  return order;
}

/// At most as large as the neighbours' covariance, thus without an allocation.
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                                  kNeighbours, kNeighbours>;
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kNeighbours, 1>;

/// The part of the covariance that Vecchia's approximation is for.
struct LocalCovariance {
  const std::vector<Position>& places;
  const std::vector<double>& noise_db2;
  const ShadowingModel& model;

  /// What no other place shares.
  double ownOf(int a) const {
    return noise_db2[static_cast<std::size_t>(a)] + model.unexplained_db2;
  }

  double sharedBy(int a, int b) const {
    const double distance =
        (places[static_cast<std::size_t>(a)] - places[static_cast<std::size_t>(b)]).norm();
    return model.shadowing_db * model.shadowing_db * std::exp(-distance / model.shadowing_distance);
  }
};

/// What is expected of a place given others: weights of their signals, and the variance left.
struct Conditional {
  SmallVector weights;
  double variance;
};

Conditional given(const std::vector<std::pair<double, int>>& others, int place,
                  const LocalCovariance& covariance) {
  const auto size = static_cast<Eigen::Index>(others.size());
  SmallMatrix among(size, size);
  SmallVector with(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const int a = others[static_cast<std::size_t>(i)].second;
    with[i] = covariance.sharedBy(a, place);
    among(i, i) = covariance.sharedBy(a, a) + covariance.ownOf(a);
    for (Eigen::Index j = 0; j < i; ++j) {  // the lower triangle is all that is read
      among(i, j) = covariance.sharedBy(a, others[static_cast<std::size_t>(j)].second);
    }
  }
  SmallVector weights = with;
  if (size > 0) {
    weights = among.ldlt().solve(with);
  }
  // No place is known better than what it alone has; rounding could say so where places coincide.
  const double own = covariance.ownOf(place);
  return {weights, std::max(covariance.sharedBy(place, place) + own - weights.dot(with), own)};
}

}  // namespace

ShadowingWhitener::ShadowingWhitener(const std::vector<Position>& places,
                                     const std::vector<double>& noise_db2,
                                     const ShadowingModel& model) {
  const LocalCovariance covariance{places, noise_db2, model};
  NearestPlaces before(places);
  row_begin_.push_back(0);
  entries_.reserve(places.size() * (kNeighbours + 1));
  for (const int place : coarseToFine(places.size())) {
    const auto& neighbours = before.nearest(places[static_cast<std::size_t>(place)], kNeighbours);
    const Conditional conditional = given(neighbours, place, covariance);
    const double scale = 1.0 / std::sqrt(conditional.variance);
    entries_.push_back({place, scale});
    for (std::size_t i = 0; i < neighbours.size(); ++i) {
      entries_.push_back(
          {neighbours[i].second, -scale * conditional.weights[static_cast<Eigen::Index>(i)]});
    }
    row_begin_.push_back(static_cast<int>(entries_.size()));
    before.enter(place);
  }
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
