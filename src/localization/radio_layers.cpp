#include "localization/radio_layers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace sfw {
namespace {

/// Mapped scans in squares of the floor.
struct ScanSquares {
  std::vector<Position> positions;  // mean of each square's scans
  std::vector<double> scans;        // how many
  std::vector<int> square_of_scan;  // -1: held out
};

ScanSquares squaresOf(const std::vector<Scan>& scans, const std::vector<bool>& used,
                      double edge_m) {
  ScanSquares squares;
  squares.square_of_scan.assign(scans.size(), -1);
  std::map<std::pair<double, double>, int> numbers;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    if (!used[i]) {
      continue;
    }
    const Position& position = scans[i].position;
    const auto [entry, is_new] = numbers.emplace(
        std::make_pair(std::floor(position.y() / edge_m), std::floor(position.x() / edge_m)),
        static_cast<int>(squares.scans.size()));
    if (is_new) {
      squares.positions.emplace_back(Position::Zero());
      squares.scans.push_back(0.0);
    }
    const auto number = static_cast<std::size_t>(entry->second);
    squares.scans[number] += 1.0;
    squares.positions[number] += (position - squares.positions[number]) / squares.scans[number];
    squares.square_of_scan[i] = entry->second;
  }
  return squares;
}

/// Squares of one metre, larger if there would be more than 2000.
ScanSquares squaresOf(const std::vector<Scan>& scans, const std::vector<bool>& used) {
  constexpr std::size_t kMostSquares = 2000;
  ScanSquares squares;
  double edge_m = 1.0;
  do {
    squares = squaresOf(scans, used, edge_m);
    edge_m *= 1.5;
  } while (squares.positions.size() > kMostSquares);
  return squares;
}

/// Weight of each square, by column, at each place, by row.
Eigen::MatrixXf kernelOf(const std::vector<Position>& places, const std::vector<Position>& squares,
                         double reach_m) {
  constexpr double kReaches = 5.0;
  Eigen::MatrixXf kernel(static_cast<Eigen::Index>(places.size()),
                         static_cast<Eigen::Index>(squares.size()));
  for (Eigen::Index j = 0; j < kernel.cols(); ++j) {
    for (Eigen::Index i = 0; i < kernel.rows(); ++i) {
      const Position way =
          places[static_cast<std::size_t>(i)] - squares[static_cast<std::size_t>(j)];
      const double reaches = way.norm() / reach_m;
      kernel(i, j) = reaches < kReaches ? std::exp(-static_cast<float>(reaches)) : 0.0F;
    }
  }
  return kernel;
}

Eigen::ArrayXf asFloats(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::ArrayXd>(values.data(), static_cast<Eigen::Index>(values.size()))
      .cast<float>();
}

}  // namespace

RadioLayers::RadioLayers(const PlaceLattice& places, const std::vector<Scan>& scans,
                         const std::vector<bool>& used, const std::vector<MappedRadio>& radios,
                         std::vector<double> weights, const Config& config)
    : config_(config), weights_(std::move(weights)), layers_(radios.size()) {
  for (std::size_t i = 0; i < radios.size(); ++i) {
    const std::vector<Sample> samples = samplesOf(radios[i], scans, used);
    if (!samples.empty() && !isStopped(config_.stop)) {
      const SignalPrediction predicted =
          SignalField(samples, radios[i].law).predict(places.points());
      layers_[i].mean_dbm = asFloats(predicted.mean_dbm);
      layers_[i].precision = asFloats(predicted.deviation_db).inverse();
      layers_[i].log_precision = layers_[i].precision.log();
    }
  }
  addChances(places, scans, used, radios);
}

void RadioLayers::addChances(const PlaceLattice& places, const std::vector<Scan>& scans,
                             const std::vector<bool>& used,
                             const std::vector<MappedRadio>& radios) {
  constexpr float kLeastChance = 0.02F;
  const ScanSquares squares = squaresOf(scans, used);
  const Eigen::MatrixXf kernel =
      kernelOf(places.points(), squares.positions, config_.heard_reach_m);
  const Eigen::ArrayXf in_square = asFloats(squares.scans);
  // Repeated scans of one square say little more.
  const Eigen::ArrayXf counted = in_square.min(static_cast<float>(config_.most_in_square));
  const auto prior = static_cast<float>(config_.heard_prior);
  const Eigen::ArrayXf all = (kernel * counted.matrix()).array() + prior;
  all_silent_ = Eigen::ArrayXf::Zero(kernel.rows());
  for (std::size_t i = 0; i < radios.size(); ++i) {
    if (!known(i)) {
      continue;
    }
    Eigen::ArrayXf heard = Eigen::ArrayXf::Zero(kernel.cols());
    for (const std::size_t scan : radios[i].scans) {
      if (used[scan]) {
        heard[squares.square_of_scan[scan]] += 1.0F;
      }
    }
    const float share = heard.sum() / in_square.sum();
    heard *= counted / in_square;
    Eigen::ArrayXf near = Eigen::ArrayXf::Constant(kernel.rows(), prior * share);
    for (Eigen::Index square = 0; square < kernel.cols(); ++square) {
      if (heard[square] > 0.0F) {
        near += kernel.col(square).array() * heard[square];
      }
    }
    const Eigen::ArrayXf chance = (near / all).max(kLeastChance).min(1.0F - kLeastChance);
    layers_[i].log_heard = chance.log();
    layers_[i].log_silent = (1.0F - chance).log();
    all_silent_ += static_cast<float>(weights_[i]) * layers_[i].log_silent;
  }
}

ScanEvidence RadioLayers::evidence(const ScanRadios& scan) const {
  const auto freedom = static_cast<float>(config_.freedom);
  // So scaled, the deviation of Student's t is that of the prediction.
  const float scale = freedom - 2.0F;
  ScanEvidence evidence{Eigen::ArrayXf::Zero(all_silent_.size()), all_silent_};
  for (std::size_t i = 0; i < scan.heard.size(); ++i) {
    const HeardRadio& heard = scan.heard[i];
    if (!known(heard.radio)) {
      continue;
    }
    const Layer& layer = layers_[heard.radio];
    const auto rssi_dbm = static_cast<float>(heard.rssi_dbm);
    evidence.signal +=
        static_cast<float>(scan.signal_weights[i]) *
        (layer.log_precision -
         0.5F * (freedom + 1.0F) *
             (1.0F + ((rssi_dbm - layer.mean_dbm) * layer.precision).square() / scale).log());
    evidence.heard +=
        static_cast<float>(weights_[heard.radio]) * (layer.log_heard - layer.log_silent);
  }
  for (const std::size_t radio : scan.repeated) {
    if (known(radio)) {
      evidence.heard -= static_cast<float>(weights_[radio]) * layers_[radio].log_silent;
    }
  }
  return evidence;
}

}  // namespace sfw
