#include "access_points/access_point_likelihood.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "radio/path_loss.h"

namespace sfw {
namespace {

constexpr int kTerms = AccessPointLikelihood::kTerms;
using Terms = Eigen::Matrix<double, kTerms, 1>;

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
                                             const Shadowing& shadowing,
                                             const ShadowingWhitener::Neighbours& neighbours)
    : access_point_(std::move(access_point)),
      whitener_(positionsOf(access_point_), noiseOfMeans(access_point_), covarianceFor(shadowing),
                neighbours),
      terms_(access_point_) {
  const auto count = static_cast<Eigen::Index>(access_point_.bins.size());
  signals_.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    signals_[i] = access_point_.bins[static_cast<std::size_t>(i)].rssi_dbm;
  }
  log_determinant_ = whitener_.logDeterminant();
  white_signals_ = whitener_.whitened(signals_);
  white_ones_ = whitener_.whitened(Eigen::VectorXd(Eigen::VectorXd::Ones(count)));
}

std::vector<double> AccessPointLikelihood::at(const std::vector<Position>& positions) const {
  std::vector<double> result;
  result.reserve(positions.size());
  std::vector<LawTerms> terms, white;
  for (std::size_t first = 0; first < positions.size(); first += kPositionLanes) {
    std::array<Position, kPositionLanes> lanes;
    for (std::size_t lane = 0; lane < kPositionLanes; ++lane) {
      lanes[lane] = positions[std::min(first + lane, positions.size() - 1)];
    }
    terms_.at(lanes, terms);
    for (const LawProducts& products :
         productsOf(terms, whitener_, white_ones_, white_signals_, white)) {
      if (result.size() < positions.size()) {
        result.push_back(logLikelihood(products));
      }
    }
  }
  return result;
}

double AccessPointLikelihood::logLikelihood(const LawProducts& products) const {
  const Moments moments = momentsOf(products);
  const Eigen::LLT<Information> factor(moments.information);
  const double half_log_determinant = factor.matrixLLT().diagonal().array().log().sum();
  return 0.5 * (moments.pull.dot(factor.solve(moments.pull)) - moments.residual) -
         half_log_determinant + log_determinant_;
}

double AccessPointLikelihood::residualAt(const Position& position) const {
  std::array<Position, kPositionLanes> lanes;
  lanes.fill(position);
  std::vector<LawTerms> terms, white;
  terms_.at(lanes, terms);
  const Moments moments =
      momentsOf(productsOf(terms, whitener_, white_ones_, white_signals_, white).front());
  const Terms law = priorMean() + priorDeviation().cwiseProduct(
                                      Terms(moments.information.llt().solve(moments.pull)));
  Eigen::Matrix<double, Eigen::Dynamic, kTerms - 1, Eigen::RowMajor> basis(signals_.size(),
                                                                           kTerms - 1);
  for (std::size_t i = 0; i < terms.size(); ++i) {
    for (std::size_t term = 0; term < kLawTerms; ++term) {
      basis(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(term)) = terms[i][term][0];
    }
  }
  const Eigen::VectorXd expected = basis * law.tail<kTerms - 1>();
  return ((signals_ - expected).array() - law[0]).matrix().norm() /
         std::sqrt(static_cast<double>(signals_.size()));
}

AccessPointLikelihood::Moments AccessPointLikelihood::momentsOf(const LawProducts& products) {
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
