#include "structure_from_wifi/belief_training.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <stdexcept>

#include "random_streams.h"
#include "structure_from_wifi/random.h"
#include "structure_from_wifi/tomography.h"

namespace sfw {
namespace {

constexpr Eigen::Index kSize = kCellFeatures + 1;  // the intercept is last
using Vector = Eigen::Matrix<double, kSize, 1>;
using Matrix = Eigen::Matrix<double, kSize, kSize>;

struct Scale {
  std::array<double, kCellFeatures> mean{};
  std::array<double, kCellFeatures> deviation{};
};

Scale scaleOf(const TrainingCells& training) {
  Scale scale;
  const auto count = static_cast<double>(training.cells.size());
  for (std::size_t i = 0; i < kCellFeatures; ++i) {
    double sum = 0.0;
    double squares = 0.0;
    for (const auto& cell : training.cells) {
      const auto value = static_cast<double>(cell[i]);
      sum += value;
      squares += value * value;
    }
    scale.mean[i] = sum / count;
    scale.deviation[i] =
        std::sqrt(std::max(squares / count - scale.mean[i] * scale.mean[i], 1e-12));
  }
  return scale;
}

Vector standardised(const std::array<float, kCellFeatures>& cell, const Scale& scale, bool radio) {
  Vector vector;
  for (std::size_t i = 0; i < kCellFeatures; ++i) {
    const bool used = radio || !usesRadio(i);
    vector[static_cast<Eigen::Index>(i)] =
        used ? (static_cast<double>(cell[i]) - scale.mean[i]) / scale.deviation[i] : 0.0;
  }
  vector[kSize - 1] = 1.0;
  return vector;
}

/// The penalised maximum of likelihood.
BeliefModel::Weights regression(const TrainingCells& training, const Scale& scale, bool radio) {
  constexpr int kIterations = 12;
  Vector weights = Vector::Zero();
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    Vector gradient = weights;
    Matrix curvature = Matrix::Identity();
    for (std::size_t i = 0; i < training.cells.size(); ++i) {
      const Vector cell = standardised(training.cells[i], scale, radio);
      const double p = 1.0 / (1.0 + std::exp(-weights.dot(cell)));
      gradient += (p - static_cast<double>(training.free[i])) * cell;
      curvature.selfadjointView<Eigen::Lower>().rankUpdate(cell, p * (1.0 - p));
    }
    weights -= curvature.selfadjointView<Eigen::Lower>().ldlt().solve(gradient);
  }
  BeliefModel::Weights result;
  result.intercept = weights[kSize - 1];
  for (std::size_t i = 0; i < kCellFeatures; ++i) {
    result.features[i] = weights[static_cast<Eigen::Index>(i)] / scale.deviation[i];
    result.intercept -= result.features[i] * scale.mean[i];
  }
  return result;
}

MappedDrive asMapped(const TrainingDrive& drive) {
  MappedDrive mapped;
  std::map<Bssid, std::size_t> index;
  for (const AccessPoint& one : drive.access_points) {
    index[one.bssid] = mapped.heard.size();
    mapped.heard.push_back({one.position, one.height_m, {}});
  }
  for (const Reading& reading : drive.readings) {
    mapped.heard[index.at(reading.bssid)].samples.push_back(
        {reading.antenna_in_map, reading.rssi_dbm});
    if (mapped.path.empty() || mapped.path.back() != reading.antenna_in_map) {
      mapped.path.push_back(reading.antenna_in_map);
    }
  }
  return mapped;
}

}  // namespace

TrainingCells cellsOf(const TrainingDrive& drive, const Config& config, std::size_t count,
                      std::int64_t seed) {
  const std::atomic<bool> never{false};
  const DescribedDrive described = describeDrive(asMapped(drive), config, never);
  const GridGeometry& geometry = described.cells.geometry;
  Random random(seed, streamOf(Purpose::kTrainingCells), 0);
  const double share =
      static_cast<double>(count) / static_cast<double>(described.cells.cells.size());
  TrainingCells training;
  training.styles.push_back(BeliefModel::styleVector(described.cells.style));
  for (std::size_t i = 0; i < described.cells.cells.size(); ++i) {
    if (random.uniform() > share) {
      continue;
    }
    const Position place =
        described.frame.toMap(geometry.centre(geometry.cell(described.cells.cells[i])));
    const Cell c = drive.truth.geometry.cellAt(place);
    const bool free = drive.truth.geometry.contains(c) && drive.truth[c] == CellState::kFree;
    training.cells.push_back(described.cells.values[i]);
    training.free.push_back(free ? 1 : 0);
  }
  return training;
}

BeliefModel::Expert fitExpert(const TrainingCells& training) {
  constexpr std::size_t kLeastDrives = 5;  // for a covariance of three figures
  if (training.cells.empty() || training.free.size() != training.cells.size() ||
      training.styles.size() < kLeastDrives) {
    throw std::invalid_argument("an expert needs cells of at least five drives");
  }
  const Scale scale = scaleOf(training);
  BeliefModel::Expert expert;
  expert.with_radio = regression(training, scale, true);
  expert.without_radio = regression(training, scale, false);
  const auto count = static_cast<double>(training.styles.size());
  for (const BeliefModel::Style& style : training.styles) {
    expert.style_mean += style / count;
  }
  // A little of the unit matrix keeps few or equal drives from a singular covariance.
  expert.style_covariance = 1e-4 * Eigen::Matrix3d::Identity();
  for (const BeliefModel::Style& style : training.styles) {
    const BeliefModel::Style away = style - expert.style_mean;
    expert.style_covariance += away * away.transpose() / count;
  }
  return expert;
}

}  // namespace sfw
