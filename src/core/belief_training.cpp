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
using Cells = Eigen::Matrix<double, kSize, Eigen::Dynamic>;
using FreeCells = Eigen::Array<std::uint8_t, Eigen::Dynamic, 1>;

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

/// Some cells, each a column with a one as its last element.
Cells standardised(const TrainingCells& training, std::size_t from, std::size_t count,
                   const Scale& scale, bool radio) {
  Cells cells = Cells::Zero(kSize, static_cast<Eigen::Index>(count));
  for (std::size_t j = 0; j < count; ++j) {
    const std::array<float, kCellFeatures>& cell = training.cells[from + j];
    const auto column = static_cast<Eigen::Index>(j);
    for (std::size_t i = 0; i < kCellFeatures; ++i) {
      if (radio || !usesRadio(i)) {
        cells(static_cast<Eigen::Index>(i), column) =
            (static_cast<double>(cell[i]) - scale.mean[i]) / scale.deviation[i];
      }
    }
    cells(kSize - 1, column) = 1.0;
  }
  return cells;
}

/// The penalised maximum of likelihood. The penalty matters little to hundreds of thousands of
/// cells, but features that nearly repeat each other share a weight instead of opposing it.
BeliefModel::Weights regression(const TrainingCells& training, const Scale& scale, bool radio) {
  constexpr int kIterations = 12;
  constexpr double kRidge = 100.0;
  constexpr std::size_t kBlock = 1000;  // cells at once: products of matrices are fast
  Vector penalty = Vector::Constant(kRidge);
  penalty[kSize - 1] = 0.0;  // the intercept's
  Vector weights = Vector::Zero();
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    Vector gradient = penalty.cwiseProduct(weights);
    Matrix curvature = penalty.asDiagonal();
    for (std::size_t from = 0; from < training.cells.size(); from += kBlock) {
      const std::size_t count = std::min(kBlock, training.cells.size() - from);
      const Cells cells = standardised(training, from, count, scale, radio);
      const Eigen::ArrayXd p = (1.0 + (-(cells.transpose() * weights).array()).exp()).inverse();
      const Eigen::Map<const FreeCells> free(training.free.data() + from,
                                             static_cast<Eigen::Index>(count));
      gradient += cells * (p - free.cast<double>()).matrix();
      curvature += cells * (p * (1.0 - p)).matrix().asDiagonal() * cells.transpose();
    }
    weights -= curvature.ldlt().solve(gradient);
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
