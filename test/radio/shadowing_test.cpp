#include "radio/shadowing.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

#include "base/random.h"
#include "radio/path_loss.h"

namespace sfw {
namespace {

/// Signals of one access point at some positions.
struct Signals {
  std::vector<Position> positions;
  std::vector<double> noise_db2;
  std::vector<double> log_distance_db;
};

Signals signalsAt(const std::vector<Position>& positions) {
  Signals signals{positions, {}, {}};
  Random random(3, 1, 0);
  for (const Position& position : positions) {
    signals.noise_db2.push_back(random.uniform(0.1, 4.0));
    signals.log_distance_db.push_back(10.0 * std::log10((position - Position(-1.0, -2.0)).norm()));
  }
  return signals;
}

Signals scattered(std::size_t count, double side) {
  Random random(1, 1, 0);
  std::vector<Position> positions;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.uniform(0.0, side);
    positions.emplace_back(x, random.uniform(0.0, side));
  }
  return signalsAt(positions);
}

/// A drive to and fro, 0.2 m between positions and 0.6 m between lanes.
Signals alongAPath(std::size_t count) {
  std::vector<Position> positions;
  for (std::size_t i = 0; i < count; ++i) {
    const auto lane = static_cast<double>(i / 30), on = static_cast<double>(i % 30);
    positions.emplace_back(0.2 * on, 0.6 * lane);
  }
  return signalsAt(positions);
}

SignalPrecision precisionOf(const Signals& signals, const SignalCovariance& model = {}) {
  const auto count = static_cast<Eigen::Index>(signals.positions.size());
  Eigen::MatrixXd basis(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    basis(i, 0) = model.power_sd_db;
    basis(i, 1) = model.exponent_sd * signals.log_distance_db[static_cast<std::size_t>(i)];
  }
  return {signals.positions, signals.noise_db2, basis, model};
}

Eigen::MatrixXd covarianceOf(const Signals& signals, const SignalCovariance& model = {}) {
  const auto count = static_cast<Eigen::Index>(signals.positions.size());
  Eigen::MatrixXd covariance(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      covariance(i, j) =
          std::pow(model.shadowing_db, 2) *
              std::exp(-(signals.positions[a] - signals.positions[b]).norm() /
                       model.shadowing_distance_m) +
          std::pow(model.power_sd_db, 2) +
          std::pow(model.exponent_sd, 2) * signals.log_distance_db[a] * signals.log_distance_db[b];
    }
    covariance(i, i) += signals.noise_db2[static_cast<std::size_t>(i)] + model.nugget_db2;
  }
  return covariance;
}

/// The precision, column by column.
Eigen::MatrixXd denseOf(const SignalPrecision& precision, std::size_t count) {
  const auto size = static_cast<Eigen::Index>(count);
  Eigen::MatrixXd dense(size, size);
  for (Eigen::Index column = 0; column < size; ++column) {
    dense.col(column) = precision.times(Eigen::VectorXd::Unit(size, column));
  }
  return dense;
}

Eigen::VectorXd randomVector(std::size_t count) {
  Random random(5, 1, 0);
  Eigen::VectorXd values(static_cast<Eigen::Index>(count));
  for (Eigen::Index i = 0; i < values.size(); ++i) {  // Eigen 3.3 has no begin()
    values[i] = random.normal();
  }
  return values;
}

TEST(SignalPrecision, IsExactForFewPositions) {
  for (std::size_t count = 1; count <= 13; ++count) {
    const Signals signals = scattered(count, 3.0);
    const Eigen::MatrixXd exact = covarianceOf(signals).inverse();
    const Eigen::MatrixXd ours = denseOf(precisionOf(signals), count);
    EXPECT_LT((ours - exact).norm(), 1e-9 * exact.norm()) << count;
  }
}

/// By which shares the variances of uncorrelated sums of signals are wrong.
Eigen::ArrayXd errorsOf(const Signals& signals) {
  const Eigen::MatrixXd covariance = covarianceOf(signals);
  const Eigen::MatrixXd precision = denseOf(precisionOf(signals), signals.positions.size());
  return (covariance * precision).eigenvalues().real().array() - 1.0;
}

double worstOf(const Eigen::ArrayXd& errors) { return errors.abs().maxCoeff(); }

double typicalOf(const Eigen::ArrayXd& errors) { return std::sqrt(errors.square().mean()); }

TEST(SignalPrecision, IsCloseForManyPositions) {
  for (const Signals& signals : {scattered(300, 10.0), scattered(300, 4.0), alongAPath(300)}) {
    const Eigen::ArrayXd errors = errorsOf(signals);
    EXPECT_LT(worstOf(errors), 0.6);
    EXPECT_LT(typicalOf(errors), 0.15);
    // Each position given its neighbours has its true variance, so nothing is lost on average.
    EXPECT_NEAR(errors.mean(), 0.0, 0.01);
    // Kullback-Leibler divergence from the true distribution, a position.
    EXPECT_LT(-0.5 * (1.0 + errors).log().mean(), 0.01);
    const Eigen::VectorXd residual = randomVector(300);
    const Eigen::VectorXd back = covarianceOf(signals) * precisionOf(signals).times(residual);
    EXPECT_LT((back - residual).norm(), 0.25 * residual.norm());
  }
}

TEST(SignalPrecision, IsSymmetricAndPositiveDefinite) {
  const Eigen::MatrixXd dense = denseOf(precisionOf(alongAPath(200)), 200);
  EXPECT_LT((dense - dense.transpose()).norm(), 1e-9 * dense.norm());
  EXPECT_GT(dense.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0.0);
}

TEST(SignalPrecision, HardlyFeelsPowerAndExponent) {
  const Signals signals = alongAPath(200);
  const SignalPrecision precision = precisionOf(signals);
  const Eigen::VectorXd constant = Eigen::VectorXd::Constant(200, 10.0);
  const Eigen::VectorXd wave = 10.0 * randomVector(200);
  const auto energy = [&](const Eigen::VectorXd& residual) {
    return residual.dot(precision.times(residual));
  };
  // Half a standard deviation of the power costs a quarter, however many positions agree.
  EXPECT_NEAR(energy(constant), 0.25, 0.01);
  EXPECT_GT(energy(wave), 1000.0 * energy(constant));
  const Eigen::VectorXd loss =
      Eigen::Map<const Eigen::VectorXd>(signals.log_distance_db.data(), 200);
  // A whole one of the exponent costs at most one half twice; power explains part of it.
  EXPECT_LT(energy(0.35 * loss), 1.0);
}

TEST(SignalPrecision, KnowsThatAnEstimatedPositionMayBeWrong) {
  const Position truth(4.0, 3.0);
  const Position estimate(4.0, 5.0);
  AccessPointBins access_point;
  access_point.position = estimate;
  access_point.noise_db2 = 1.0;
  for (const Position& position : scattered(200, 12.0).positions) {
    access_point.bins.push_back({position, 0.0, 1.0});
  }
  // What the signals are beside those that the estimate predicts.
  AccessPointBins there = access_point;
  there.position = truth;
  Eigen::VectorXd residual(200);
  for (Eigen::Index i = 0; i < 200; ++i) {
    const Position& at = access_point.bins[static_cast<std::size_t>(i)].position;
    residual[i] = kPriorExponent * (logDistance(access_point, at) - logDistance(there, at));
  }
  const auto energy = [&](const AccessPointBins& bins) {
    return residual.dot(SignalPrecision(bins, {}).times(residual));
  };
  const double as_known = energy(access_point);
  access_point.covariance = Eigen::Vector2d(0.25, 4.0).asDiagonal();
  EXPECT_LT(energy(access_point), 0.5 * as_known);
  access_point.covariance = Eigen::Vector2d(4.0, 0.01).asDiagonal();  // sure of y, wrongly
  EXPECT_GT(energy(access_point), 0.7 * as_known);
}

TEST(SignalPrecision, DoesNotDependOnWhereTheMapLies) {
  Signals moved = scattered(300, 10.0);
  const SignalPrecision here = precisionOf(moved);
  for (Position& position : moved.positions) {
    position = Position(1024.0, -512.0) + position;
  }
  const Eigen::VectorXd residual = randomVector(300);
  const Eigen::VectorXd expected = here.times(residual);
  EXPECT_LT((precisionOf(moved).times(residual) - expected).norm(), 1e-6 * expected.norm());
}

TEST(SignalPrecision, WorksWithoutPositions) {
  EXPECT_EQ(precisionOf(signalsAt({})).times(Eigen::VectorXd()).size(), 0);
}

TEST(SignalPrecision, StaysFiniteWherePositionsCoincideAndNothingIsNoisy) {
  Signals signals = signalsAt(std::vector<Position>(40, Position(1.0, 1.0)));
  signals.noise_db2.assign(40, 1e-18);
  SignalCovariance model;
  model.nugget_db2 = 0.0;
  EXPECT_TRUE(precisionOf(signals, model).times(randomVector(40)).allFinite());
}

TEST(SignalPrecision, FindsNeighboursInAnyLayout) {
  // One far outlier, all on a line, and a lattice full of ties.
  Signals outlier = scattered(100, 2.0);
  outlier.positions.front() = Position(5000.0, 5000.0);
  std::vector<Position> line, lattice;
  for (int i = 0; i < 100; ++i) {
    line.emplace_back(0.2 * i, 3.0);
    lattice.emplace_back(0.2 * (i % 10), 0.2 * (i / 10));
  }
  for (const Signals& signals :
       {signalsAt(outlier.positions), signalsAt(line), signalsAt(lattice)}) {
    const Eigen::ArrayXd errors = errorsOf(signals);
    EXPECT_LT(worstOf(errors), 0.6);
    EXPECT_LT(typicalOf(errors), 0.15);
  }
}

}  // namespace
}  // namespace sfw
