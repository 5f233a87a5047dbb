#include "access_point_likelihood.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <utility>
#include <vector>

namespace sfw {
namespace {

constexpr double kDecibel = 0.2302585092994045684;  // as a natural logarithm of power

constexpr int kTerms = AccessPointLikelihood::kTerms;
using Basis = AccessPointLikelihood::Basis;
using Terms = Eigen::Matrix<double, kTerms, 1>;
using Information = Eigen::Matrix<double, kTerms, kTerms>;

constexpr double kUsualClimb = 0.8;  // [m], from antenna to access point where nobody says

// Chosen so that the true places of simulated access points are likeliest (doc/algorithm.md).
Terms priorMean() {
  return (Terms() << kPriorPower, -kPriorExponent, -0.6, 0.0, 0.0, 0.0, 0.0).finished();
}
Terms priorDeviation() { return (Terms() << 8.0, 0.4, 0.6, 1.6, 1.6, 1.4, 1.4).finished(); }

ShadowingModel modelOf(const AccessPointLikelihood::Shadowing& shadowing) {
  ShadowingModel model;
  model.shadowing_db = shadowing.deviation_db;
  model.shadowing_distance = shadowing.distance_m;
  model.unexplained_db2 = 0.5;
  return model;
}

ShadowingWhitener whitenerOf(const HeardAccessPoint& heard, const ShadowingModel& model) {
  std::vector<Position> places;
  std::vector<double> noise;
  for (const RadioBin& bin : heard.bins) {
    places.push_back(bin.place);
    noise.push_back(heard.noise_db2 / bin.readings);
  }
  return {places, noise, model};
}

/// Of the factor, a triangle but for the order of its rows. Each row is 1 / s for its own place
/// and, for places before it, as much times weights below 1: the largest entry stands on the
/// diagonal.
double logDeterminantOf(const ShadowingWhitener& whitener, std::size_t places) {
  const auto size = static_cast<Eigen::Index>(places);
  const Eigen::MatrixXd factor = whitener.whitened(Eigen::MatrixXd::Identity(size, size).eval());
  return factor.rowwise().maxCoeff().array().log().sum();
}

/// In space [m]. On the floor alone it would pass through 0, and the law would have it that
/// readings near the access point tell its place to the decimetre.
double distanceTo(const HeardAccessPoint& standing, const Position& place) {
  const double distance = std::exp(kDecibel * logDistance(standing, place));
  return standing.height_m ? distance : std::hypot(distance, kUsualClimb);
}

}  // namespace

AccessPointLikelihood::AccessPointLikelihood(HeardAccessPoint heard, const Shadowing& shadowing)
    : heard_(std::move(heard)),
      whitener_(whitenerOf(heard_, modelOf(shadowing))),
      log_determinant_(logDeterminantOf(whitener_, heard_.bins.size())) {
  signals_.resize(static_cast<Eigen::Index>(heard_.bins.size()));
  for (std::size_t i = 0; i < heard_.bins.size(); ++i) {
    signals_[static_cast<Eigen::Index>(i)] = heard_.bins[i].rssi_dbm;
  }
  white_signals_ = whitener_.whitened(signals_);
}

double AccessPointLikelihood::at(const Position& place) const {
  const Basis basis = whiteBasis(place);
  const Eigen::VectorXd residual = white_signals_ - basis * priorMean();
  const Basis scaled = basis * priorDeviation().asDiagonal();
  const Information information = Information::Identity() + scaled.transpose() * scaled;
  const Eigen::LLT<Information> factor(information);
  const Terms pull = scaled.transpose() * residual;
  const double half_log_determinant = factor.matrixLLT().diagonal().array().log().sum();
  return 0.5 * (pull.dot(factor.solve(pull)) - residual.squaredNorm()) - half_log_determinant +
         log_determinant_;
}

double AccessPointLikelihood::residualAt(const Position& place) const {
  const Basis white = whiteBasis(place);
  const Basis scaled = white * priorDeviation().asDiagonal();
  const Information information = Information::Identity() + scaled.transpose() * scaled;
  const Terms pull = scaled.transpose() * (white_signals_ - white * priorMean());
  const Terms law =
      priorMean() + priorDeviation().cwiseProduct(Terms(information.llt().solve(pull)));
  return (signals_ - basisAt(place) * law).norm() / std::sqrt(static_cast<double>(signals_.size()));
}

Basis AccessPointLikelihood::basisAt(const Position& place) const {
  HeardAccessPoint standing;
  standing.position = place;
  standing.height_m = heard_.height_m;
  Basis basis(signals_.size(), kTerms);
  for (Eigen::Index i = 0; i < signals_.size(); ++i) {
    const Position& bin = heard_.bins[static_cast<std::size_t>(i)].place;
    const double distance = distanceTo(standing, bin);
    const double loss = std::log(distance) / kDecibel;
    const Position way = (bin - place) / distance;
    basis.row(i) << 1.0, loss, distance, way.x(), way.y(), way.x() * way.x() - way.y() * way.y(),
        2.0 * way.x() * way.y();
  }
  return basis;
}

Basis AccessPointLikelihood::whiteBasis(const Position& place) const {
  return whitener_.whitened(basisAt(place));
}

}  // namespace sfw
