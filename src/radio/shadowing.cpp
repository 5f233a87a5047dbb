#include "radio/shadowing.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "radio/nearest_places.h"

namespace sfw {
namespace {

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

/// Numbers of several places side by side: calculating with all takes as long as with one.
constexpr int kLanes = 4;
using Lanes = Eigen::Array<double, kLanes, 1>;

/// What is expected of places, each given others by the part of the covariance that Vecchia's
/// approximation is for: weights of the others' signals, and the variance left.
template <int kOthers>
class Conditional {
 public:
  /// @param lane   of the place in question
  /// @param index  0 for the place itself, then the others from 1 on
  /// @param own    variance that no other place shares
  void put(int lane, int index, const Position& place, double own) {
    const auto i = static_cast<std::size_t>(index);
    x_[i][lane] = place.x();
    y_[i][lane] = place.y();
    own_[i][lane] = own;
    known_[i][lane] = 1.0;
  }

  /// Instead of another place where there are no more: shares nothing.
  void putNone(int lane, int index) {
    put(lane, index, Position::Zero(), 1.0);
    known_[static_cast<std::size_t>(index)][lane] = 0.0;
  }

  void solve(const ShadowingModel& model) {
    const double variance_db2 = model.shadowing_db * model.shadowing_db;
    const double rate = -1.0 / model.shadowing_distance;
    const auto shared = [&](std::size_t i, std::size_t j) -> Lanes {
      const Lanes distance = ((x_[i] - x_[j]).square() + (y_[i] - y_[j]).square()).sqrt();
      return variance_db2 * known_[i] * known_[j] * (rate * distance).exp();
    };
    // Factors into L D L' and solves forwards; `row` holds L D, `factor_` holds L.
    Lanes left = variance_db2 + own_[0];
    for (std::size_t i = 0; i < kOthers; ++i) {
      Lanes pivot = variance_db2 + own_[i + 1];
      Lanes forwards = shared(i + 1, 0);
      std::array<Lanes, kOthers> row;
      for (std::size_t j = 0; j < i; ++j) {
        row[j] = shared(i + 1, j + 1);
        for (std::size_t k = 0; k < j; ++k) {
          row[j] -= row[k] * factor_[j][k];
        }
        factor_[i][j] = row[j] * inverse_pivot_[j];
        pivot -= row[j] * factor_[i][j];
        forwards -= factor_[i][j] * weight_[j];
      }
      // No place is known better than what it alone has; rounding could say so where places
      // coincide.
      inverse_pivot_[i] = pivot.max(own_[i + 1]).inverse();
      weight_[i] = forwards;
      left -= forwards.square() * inverse_pivot_[i];
    }
    for (std::size_t i = kOthers; i-- > 0;) {
      weight_[i] *= inverse_pivot_[i];
      for (std::size_t j = i + 1; j < kOthers; ++j) {
        weight_[i] -= factor_[j][i] * weight_[j];
      }
    }
    scale_ = left.max(own_[0]).sqrt().inverse();
  }

  /// One over the standard deviation left.
  double scale(int lane) const { return scale_[lane]; }

  /// Of the others from 0 on.
  double weight(int lane, int other) const {
    return weight_[static_cast<std::size_t>(other)][lane];
  }

 private:
  std::array<Lanes, kOthers + 1> x_, y_, own_, known_;
  std::array<std::array<Lanes, kOthers>, kOthers> factor_;
  std::array<Lanes, kOthers> inverse_pivot_, weight_;
  Lanes scale_;
};

/// Adds what one row l of the factor L has of L' L v, l' (l v).
template <class Row, class Scalar>
void addWhitenedTwice(const Row& row, const Scalar* values, Scalar* sums) {
  // Several sums, as each addition waits for the one before.
  constexpr std::size_t kSums = 4;
  std::array<Scalar, kSums> white{};
  for (std::size_t i = 0; i < row.place.size(); ++i) {
    white[i % kSums] += row.weight[i] * values[row.place[i]];
  }
  const Scalar all = (white[0] + white[1]) + (white[2] + white[3]);
  for (std::size_t i = 0; i < row.place.size(); ++i) {
    sums[row.place[i]] += row.weight[i] * all;
  }
}

}  // namespace

ShadowingWhitener::ShadowingWhitener(const std::vector<Position>& places,
                                     const std::vector<double>& noise_db2,
                                     const ShadowingModel& model) {
  NearestPlaces before(places);
  std::vector<int> known;  // neighbours of each row
  rows_.reserve(places.size());
  known.reserve(places.size());
  for (const int place : coarseToFine(places.size())) {
    Row<double> row{};
    row.place.fill(place);
    known.push_back(0);
    for (const auto& [square, other] :
         before.nearest(places[static_cast<std::size_t>(place)], kNeighbours)) {
      row.place[static_cast<std::size_t>(++known.back())] = other;
    }
    rows_.push_back(row);
    before.enter(place);
  }
  Conditional<kNeighbours> conditional;
  for (std::size_t first = 0; first < rows_.size(); first += kLanes) {
    const auto rowOf = [&](int lane) {  // the last one again where there are no more
      return std::min(first + static_cast<std::size_t>(lane), rows_.size() - 1);
    };
    for (int lane = 0; lane < kLanes; ++lane) {
      for (int i = 0; i <= kNeighbours; ++i) {
        if (i > known[rowOf(lane)]) {
          conditional.putNone(lane, i);
          continue;
        }
        const auto place =
            static_cast<std::size_t>(rows_[rowOf(lane)].place[static_cast<std::size_t>(i)]);
        conditional.put(lane, i, places[place], noise_db2[place] + model.unexplained_db2);
      }
    }
    conditional.solve(model);
    for (int lane = 0; lane < kLanes; ++lane) {
      std::array<double, kNeighbours + 1>& weight = rows_[rowOf(lane)].weight;
      weight[0] = conditional.scale(lane);
      for (int i = 0; i < kNeighbours; ++i) {
        weight[static_cast<std::size_t>(i) + 1] = -weight[0] * conditional.weight(lane, i);
      }
    }
  }
}

Eigen::VectorXd ShadowingWhitener::applyPrecision(const Eigen::VectorXd& values) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(values.size());
  for (const Row<double>& row : rows_) {
    addWhitenedTwice(row, values.data(), result.data());
  }
  return result;
}

double ShadowingWhitener::logDeterminant() const {
  // L is a triangle but for the order of its rows, and a row's first weight stands on the diagonal.
  double sum = 0.0;
  for (const Row<double>& row : rows_) {
    sum += std::log(row.weight[0]);
  }
  return sum;
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
    solved_basis_.col(column) = whitener_.applyPrecision(basis.col(column));
  }
  capacitance_ = (Eigen::Matrix2d::Identity() + basis.transpose() * solved_basis_).inverse();
}

Eigen::VectorXd SignalPrecision::times(const Eigen::VectorXd& residual) const {
  return whitener_.applyPrecision(residual) -
         solved_basis_ * (capacitance_ * (solved_basis_.transpose() * residual));
}

SignalPrecisionF::SignalPrecisionF(const SignalPrecision& exact)
    : solved_basis_(exact.solved_basis_.cast<float>()),
      capacitance_(exact.capacitance_.cast<float>()) {
  rows_.reserve(exact.whitener_.rows_.size());
  for (const ShadowingWhitener::Row<double>& row : exact.whitener_.rows_) {
    rows_.push_back({row.place, {}});
    std::transform(row.weight.begin(), row.weight.end(), rows_.back().weight.begin(),
                   [](double weight) { return static_cast<float>(weight); });
  }
}

void SignalPrecisionF::times(Eigen::Ref<const Eigen::VectorXf> residual,
                             Eigen::Ref<Eigen::VectorXf> product) const {
  const Eigen::Vector2f common = capacitance_ * (solved_basis_.transpose() * residual);
  product.noalias() = -solved_basis_ * common;
  for (const ShadowingWhitener::Row<float>& row : rows_) {
    addWhitenedTwice(row, residual.data(), product.data());
  }
}

}  // namespace sfw
