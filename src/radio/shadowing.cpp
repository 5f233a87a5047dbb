#include "radio/shadowing.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

#include "radio/nearest_neighbours.h"
#include "radio/path_loss.h"
#include "radio/vecchia_rows.h"

namespace sfw {
namespace {

/// Numbers of positions from coarse to fine. Each position has neighbours on all sides among the
/// earlier ones. The bits of a number in reverse order give its rank.
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

/// Adds the part of L' L v that comes from one row l of the factor L: l' (l v).
void addRowProduct(const ShadowingWhitener::Row<double>& row, const double* values, double* sums) {
  // Several sums are used, because each addition waits for the previous one.
  constexpr std::size_t kSums = 4;
  std::array<double, kSums> white{};
  for (std::size_t i = 0; i < row.index.size(); ++i) {
    white[i % kSums] += row.weight[i] * values[row.index[i]];
  }
  const double all = (white[0] + white[1]) + (white[2] + white[3]);
  for (std::size_t i = 0; i < row.index.size(); ++i) {
    sums[row.index[i]] += row.weight[i] * all;
  }
}

/// The same in single precision. Four products are calculated at once; the sums are those of above.
void addRowProduct(const ShadowingWhitener::Row<float>& row, const float* values, float* sums) {
  using Vector = float __attribute__((vector_size(16)));
  constexpr std::size_t kLast = ShadowingWhitener::kNeighbours;
  constexpr std::size_t kVectors = kLast / 4;
  static_assert(kLast == 4 * kVectors, "one weight is left over");
  const auto& index = row.index;
  std::array<Vector, kVectors> weight;
  std::memcpy(weight.data(), row.weight.data(), sizeof(weight));
  Vector white{};
  for (std::size_t i = 0; i < kVectors; ++i) {
    white += weight[i] * Vector{values[index[4 * i]], values[index[4 * i + 1]],
                                values[index[4 * i + 2]], values[index[4 * i + 3]]};
  }
  white[0] += row.weight[kLast] * values[index[kLast]];
  const float all = (white[0] + white[1]) + (white[2] + white[3]);
  for (std::size_t i = 0; i < kVectors; ++i) {
    const Vector product = weight[i] * all;
    for (std::size_t j = 0; j < 4; ++j) {
      sums[index[4 * i + j]] += product[j];
    }
  }
  sums[index[kLast]] += row.weight[kLast] * all;
}

/// Derivatives of the mean signals by the position of the access point along the axes of its
/// covariance, times the standard deviations along these axes [dB].
Eigen::MatrixX2d positionTerms(const AccessPointBins& access_point) {
  constexpr double kDbPerMetre = 10.0 / 2.302585092994046 * kPriorExponent;  // at 1 m
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(access_point.covariance);
  const Eigen::Matrix2d scaled =
      axes.eigenvectors() * axes.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
  Eigen::MatrixX2d terms(static_cast<Eigen::Index>(access_point.bins.size()), 2);
  for (std::size_t i = 0; i < access_point.bins.size(); ++i) {
    const Position away = access_point.bins[i].position - access_point.position;
    // Nearer than the deviation itself, the derivative does not describe the signals.
    const double square = std::max(away.squaredNorm(), access_point.covariance.trace());
    terms.row(static_cast<Eigen::Index>(i)) =
        kDbPerMetre / std::max(square, kNearFieldM * kNearFieldM) * away.transpose() * scaled;
  }
  return terms;
}

/// The terms of power, exponent and, unless it is known, position.
Eigen::MatrixXd basisOf(const AccessPointBins& access_point, const SignalCovariance& model) {
  const bool is_known = access_point.covariance.isZero(0.0);
  const auto count = static_cast<Eigen::Index>(access_point.bins.size());
  Eigen::MatrixXd basis(count, is_known ? 2 : 4);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Position& position = access_point.bins[static_cast<std::size_t>(i)].position;
    basis(i, 0) = model.power_sd_db;
    basis(i, 1) = model.exponent_sd * logDistance(access_point, position);
  }
  if (!is_known) {
    basis.rightCols<2>() = positionTerms(access_point);
  }
  return basis;
}

}  // namespace

ShadowingWhitener::ShadowingWhitener(const std::vector<Position>& positions,
                                     const std::vector<double>& noise_db2,
                                     const SignalCovariance& model)
    : ShadowingWhitener(positions, noise_db2, model, Neighbours(positions)) {}

ShadowingWhitener::ShadowingWhitener(const std::vector<Position>& positions,
                                     const std::vector<double>& noise_db2,
                                     const SignalCovariance& model, const Neighbours& neighbours) {
  rows_.reserve(neighbours.index_.size());
  for (const auto& index : neighbours.index_) {
    rows_.push_back({index, {}});
  }
  VecchiaRows<kNeighbours> batch;
  for (std::size_t first = 0; first < rows_.size(); first += kLanes) {
    const auto row = [&](int lane) {  // the last one again where there are no more
      return std::min(first + static_cast<std::size_t>(lane), rows_.size() - 1);
    };
    for (int lane = 0; lane < kLanes; ++lane) {
      for (int i = 0; i <= kNeighbours; ++i) {
        if (i > neighbours.known_[row(lane)]) {
          batch.putNone(lane, i);
          continue;
        }
        const auto index =
            static_cast<std::size_t>(rows_[row(lane)].index[static_cast<std::size_t>(i)]);
        batch.put(lane, i, positions[index], noise_db2[index] + model.nugget_db2);
      }
    }
    batch.solve(model);
    for (int lane = 0; lane < kLanes; ++lane) {
      std::array<double, kNeighbours + 1>& weight = rows_[row(lane)].weight;
      weight[0] = batch.scale(lane);
      for (int i = 0; i < kNeighbours; ++i) {
        weight[static_cast<std::size_t>(i) + 1] = -weight[0] * batch.weight(lane, i);
      }
    }
  }
}

ShadowingWhitener::Neighbours::Neighbours(const std::vector<Position>& positions) {
  NearestNeighbours before(positions);
  index_.reserve(positions.size());
  known_.reserve(positions.size());
  for (const int own : coarseToFine(positions.size())) {
    index_.emplace_back().fill(own);
    known_.push_back(0);
    for (const auto& [square, neighbour] :
         before.nearest(positions[static_cast<std::size_t>(own)], kNeighbours)) {
      index_.back()[static_cast<std::size_t>(++known_.back())] = neighbour;
    }
    before.enter(own);
  }
}

Eigen::VectorXd ShadowingWhitener::applyPrecision(const Eigen::VectorXd& values) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(values.size());
  for (const Row<double>& row : rows_) {
    addRowProduct(row, values.data(), result.data());
  }
  return result;
}

double ShadowingWhitener::logDeterminant() const {
  // L is triangular except for the order of its rows. A row's first weight is on the diagonal.
  double sum = 0.0;
  for (const Row<double>& row : rows_) {
    sum += std::log(row.weight[0]);
  }
  return sum;
}

SignalPrecision::SignalPrecision(const AccessPointBins& access_point, const SignalCovariance& model)
    : SignalPrecision(positionsOf(access_point), noiseOfMeans(access_point),
                      basisOf(access_point, model), model) {}

SignalPrecision::SignalPrecision(const std::vector<Position>& positions,
                                 const std::vector<double>& noise_db2, const Eigen::MatrixXd& basis,
                                 const SignalCovariance& model)
    : whitener_(positions, noise_db2, model) {
  solved_basis_.resize(basis.rows(), basis.cols());
  for (Eigen::Index column = 0; column < basis.cols(); ++column) {
    solved_basis_.col(column) = whitener_.applyPrecision(basis.col(column));
  }
  capacitance_ =
      (Eigen::MatrixXd::Identity(basis.cols(), basis.cols()) + basis.transpose() * solved_basis_)
          .inverse();
}

Eigen::VectorXd SignalPrecision::times(const Eigen::VectorXd& residual) const {
  return whitener_.applyPrecision(residual) -
         solved_basis_ * (capacitance_ * (solved_basis_.transpose() * residual));
}

SignalPrecisionF::SignalPrecisionF(const SignalPrecision& exact)
    : solved_basis_(exact.solved_basis_.cast<float>()),
      capacitance_(exact.capacitance_.cast<float>()) {
  rows_.reserve(exact.whitener_.rows().size());
  for (const ShadowingWhitener::Row<double>& row : exact.whitener_.rows()) {
    rows_.push_back({row.index, {}});
    std::transform(row.weight.begin(), row.weight.end(), rows_.back().weight.begin(),
                   [](double weight) { return static_cast<float>(weight); });
  }
}

void SignalPrecisionF::times(const Eigen::Ref<const Eigen::VectorXf>& residual,
                             Eigen::Ref<Eigen::VectorXf> product) const {
  using Terms = Eigen::Matrix<float, Eigen::Dynamic, 1, 0, 4, 1>;  // without the heap
  const Terms common = capacitance_ * (solved_basis_.transpose() * residual);
  product.noalias() = -solved_basis_ * common;
  for (const ShadowingWhitener::Row<float>& row : rows_) {
    addRowProduct(row, residual.data(), product.data());
  }
}

}  // namespace sfw
