#include "access_points/access_point_likelihood.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "base/random.h"
#include "radio/path_loss.h"

namespace sfw {
namespace {

constexpr AccessPointLikelihood::Shadowing kShadowing{3.0, 1.5};

/// Bins on a lattice of an area of 6 x 4 m with noisy signals.
AccessPointBins noisyBins(std::optional<double> height_m) {
  Random random(7, 8, 9);
  AccessPointBins access_point;
  access_point.height_m = height_m;
  access_point.noise_db2 = 9.0;
  for (int i = 0; i < 45; ++i) {
    const Position position(0.7 * (i % 9), 0.8 * (i / 9));
    const double readings = 1.0 + i % 4;
    access_point.bins.push_back(
        {position, -55.0 - 2.0 * position.x() + 3.0 * random.normal(), readings});
  }
  return access_point;
}

AccessPointLikelihood likelihoodOf(const AccessPointBins& access_point) {
  return {access_point, kShadowing, ShadowingWhitener::Neighbours(positionsOf(access_point))};
}

std::vector<Position> somePositions() {
  return {{1.0, 2.0}, {-3.0, 0.5}, {4.9, 3.2}, {2.8, 1.6}, {9.0, -4.0}, {0.1, 0.1}, {5.5, 5.5}};
}

/// The law's terms at a bin, all but the first one.
Eigen::RowVectorXd termsAt(const AccessPointBins& access_point, const RadioBin& bin,
                           const Position& position) {
  const Position away = bin.position - position;
  const double space =
      spaceDistance(away.squaredNorm(), antennaToAccessPoint(access_point.height_m));
  const double distance = access_point.height_m ? space : std::hypot(space, 0.8);
  const double x = away.x() / distance;
  const double y = away.y() / distance;
  Eigen::RowVectorXd terms(6);
  terms << 10.0 * std::log10(distance), distance, x, y, x * x - y * y, 2.0 * x * y;
  return terms;
}

/// The same likelihood up to a constant, for one position, by dense matrices.
double plainLikelihood(const AccessPointBins& access_point, const Position& position) {
  SignalCovariance model;
  model.shadowing_db = kShadowing.deviation_db;
  model.shadowing_distance_m = kShadowing.distance_m;
  model.nugget_db2 = 0.5;
  const ShadowingWhitener whitener(access_point, model);
  const auto count = static_cast<Eigen::Index>(access_point.bins.size());
  Eigen::MatrixXd basis = Eigen::MatrixXd::Ones(count, 7);
  Eigen::VectorXd signals(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const RadioBin& bin = access_point.bins[static_cast<std::size_t>(i)];
    basis.row(i).tail(6) = termsAt(access_point, bin, position);
    signals[i] = bin.rssi_dbm;
  }
  const Eigen::VectorXd mean =
      (Eigen::VectorXd(7) << kPriorPowerDbm, -kPriorExponent, -0.6, 0, 0, 0, 0).finished();
  const Eigen::VectorXd deviation =
      (Eigen::VectorXd(7) << 8.0, 0.4, 0.6, 1.6, 1.6, 1.4, 1.4).finished();
  const Eigen::MatrixXd white = whitener.whitened(basis);
  const Eigen::MatrixXd scaled = white * deviation.asDiagonal();
  const Eigen::VectorXd residual = whitener.whitened(signals) - white * mean;
  const Eigen::LLT<Eigen::MatrixXd> factor(Eigen::MatrixXd::Identity(7, 7) +
                                           scaled.transpose() * scaled);
  const Eigen::VectorXd pull = scaled.transpose() * residual;
  const double half_log_determinant = factor.matrixLLT().diagonal().array().log().sum();
  return 0.5 * (pull.dot(factor.solve(pull)) - residual.squaredNorm()) - half_log_determinant;
}

TEST(AccessPointLikelihood, IsThatOfDenseMatricesUpToAConstant) {
  for (const std::optional<double> height_m : {std::optional<double>(), std::optional(2.4)}) {
    const AccessPointBins access_point = noisyBins(height_m);
    const AccessPointLikelihood likelihood = likelihoodOf(access_point);
    const std::vector<Position> positions = somePositions();
    const double constant =
        likelihood.at(positions[0]) - plainLikelihood(access_point, positions[0]);
    for (const Position& position : positions) {
      EXPECT_NEAR(likelihood.at(position), plainLikelihood(access_point, position) + constant,
                  1e-9);
    }
  }
}

TEST(AccessPointLikelihood, OfAPositionDoesNotDependOnTheOthersRatedWithIt) {
  const AccessPointLikelihood likelihood = likelihoodOf(noisyBins(std::nullopt));
  const std::vector<Position> positions = somePositions();
  const std::vector<double> together = likelihood.at(positions);
  ASSERT_EQ(together.size(), positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    EXPECT_EQ(together[i], likelihood.at(positions[i])) << i;
  }
  EXPECT_TRUE(likelihood.at(std::vector<Position>()).empty());
}

}  // namespace
}  // namespace sfw
