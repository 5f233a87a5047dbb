#include "access_points/access_point_likelihood.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <utility>

#include "radio/path_loss.h"

namespace sfw {
namespace {

constexpr int kTerms = AccessPointLikelihood::kTerms;
using Terms = Eigen::Matrix<double, kTerms, 1>;

constexpr double kUsualRiseM = 0.8;  // from antenna to access point, where the height is unknown

// These maximise the likelihood of the true positions in simulation (doc/results/ablations.md).
Terms priorMean() {
  return (Terms() << kPriorPowerDbm, -kPriorExponent, -0.6, 0.0, 0.0, 0.0, 0.0).finished();
}
Terms priorDeviation() { return (Terms() << 8.0, 0.4, 0.6, 1.6, 1.6, 1.4, 1.4).finished(); }

SignalCovariance covarianceFor(const AccessPointLikelihood::Shadowing& shadowing) {
  SignalCovariance model;
  model.shadowing_db = shadowing.deviation_db;
  model.shadowing_distance_m = shadowing.distance_m;
  model.nugget_db2 = 0.5;
  return model;
}

}  // namespace

AccessPointLikelihood::AccessPointLikelihood(AccessPointBins access_point,
                                             const Shadowing& shadowing)
    : access_point_(std::move(access_point)), whitener_(access_point_, covarianceFor(shadowing)) {
  const auto count = static_cast<Eigen::Index>(access_point_.bins.size());
  x_.resize(count);
  y_.resize(count);
  signals_.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const RadioBin& bin = access_point_.bins[static_cast<std::size_t>(i)];
    x_[i] = bin.position.x();
    y_[i] = bin.position.y();
    signals_[i] = bin.rssi_dbm;
  }
  log_determinant_ = whitener_.logDeterminant();
  white_signals_ = whitener_.whitened(signals_);
  white_ones_ = whitener_.whitened(Eigen::VectorXd(Eigen::VectorXd::Ones(count)));
}

double AccessPointLikelihood::at(const Position& position) const {
  const Moments moments = momentsAt(position);
  const Eigen::LLT<Information> factor(moments.information);
  const double half_log_determinant = factor.matrixLLT().diagonal().array().log().sum();
  return 0.5 * (moments.pull.dot(factor.solve(moments.pull)) - moments.residual) -
         half_log_determinant + log_determinant_;
}

double AccessPointLikelihood::residualAt(const Position& position) const {
  const Moments moments = momentsAt(position);
  const Terms law = priorMean() + priorDeviation().cwiseProduct(
                                      Terms(moments.information.llt().solve(moments.pull)));
  const Eigen::VectorXd expected = basisAt(position) * law.tail<kTerms - 1>();
  return ((signals_ - expected).array() - law[0]).matrix().norm() /
         std::sqrt(static_cast<double>(signals_.size()));
}

AccessPointLikelihood::Basis AccessPointLikelihood::basisAt(const Position& position) const {
  const Eigen::ArrayXd away_x = x_ - position.x();
  const Eigen::ArrayXd away_y = y_ - position.y();
  Eigen::ArrayXd squares =
      spaceDistance(away_x.square() + away_y.square(), access_point_.height_m).square();
  if (!access_point_.height_m) {
    // Without a difference of height the distance could be 0. Then readings near the access point
    // would determine its position to the decimetre.
    squares += kUsualRiseM * kUsualRiseM;
  }
  const Eigen::ArrayXd distance = squares.sqrt();
  const Eigen::ArrayXd way_x = away_x / distance;
  const Eigen::ArrayXd way_y = away_y / distance;
  Basis basis(signals_.size(), kTerms - 1);
  basis.col(0) = 10.0 / std::log(10.0) * distance.log();
  basis.col(1) = distance;
  basis.col(2) = way_x;
  basis.col(3) = way_y;
  basis.col(4) = way_x.square() - way_y.square();
  basis.col(5) = 2.0 * way_x * way_y;
  return basis;
}

AccessPointLikelihood::Moments AccessPointLikelihood::momentsAt(const Position& position) const {
  const Basis white = whitener_.whitened(basisAt(position));
  Eigen::Matrix<double, kTerms + 1, kTerms + 1> products;
  products.setZero();
  for (Eigen::Index i = 0; i < white.rows(); ++i) {
    Eigen::Matrix<double, kTerms + 1, 1> row;
    row << white_ones_[i], white.row(i).transpose(), white_signals_[i];
    products.noalias() += row * row.transpose();
  }
  const Information squares = products.topLeftCorner<kTerms, kTerms>();
  const Terms with_signals = products.topRightCorner<kTerms, 1>();
  const Terms mean = priorMean();
  const Terms deviation = priorDeviation();
  Moments moments;
  moments.information =
      Information::Identity() + deviation.asDiagonal() * squares * deviation.asDiagonal();
  moments.pull = deviation.cwiseProduct(with_signals - squares * mean);
  moments.residual =
      products(kTerms, kTerms) - 2.0 * mean.dot(with_signals) + mean.dot(squares * mean);
  return moments;
}

}  // namespace sfw
