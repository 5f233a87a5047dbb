#include "training/belief_training.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <stdexcept>

#include "base/random.h"
#include "base/random_streams.h"
#include "belief/drive_features.h"

namespace sfw {
namespace {

constexpr Eigen::Index kSize = kCellFeatures + 1;  // the intercept is last
using Vector = Eigen::Matrix<double, kSize, 1>;
using Matrix = Eigen::Matrix<double, kSize, kSize>;
using Cells = Eigen::Matrix<double, kSize, Eigen::Dynamic>;
using FreeCells = Eigen::Array<std::uint8_t, Eigen::Dynamic, 1>;

/// A drive and its weight in a fit.
struct WeightedDrive {
  const TrainingCells* drive;
  double weight;
};

struct Scale {
  std::array<double, kCellFeatures> mean{};
  std::array<double, kCellFeatures> deviation{};
};

Scale scaleOf(const std::vector<WeightedDrive>& training) {
  Scale scale;
  double count = 0.0;
  std::array<double, kCellFeatures> squares{};
  for (const WeightedDrive& one : training) {
    for (const auto& cell : one.drive->cells) {
      for (std::size_t i = 0; i < kCellFeatures; ++i) {
        const auto value = static_cast<double>(cell[i]);
        scale.mean[i] += one.weight * value;
        squares[i] += one.weight * value * value;
      }
    }
    count += one.weight * static_cast<double>(one.drive->cells.size());
  }
  for (std::size_t i = 0; i < kCellFeatures; ++i) {
    scale.mean[i] /= count;
    scale.deviation[i] =
        std::sqrt(std::max(squares[i] / count - scale.mean[i] * scale.mean[i], 1e-12));
  }
  return scale;
}

/// Standardises some cells. Each cell becomes a column with a one as its last element.
Cells standardised(const TrainingCells& drive, std::size_t from, std::size_t count,
                   const Scale& scale, UseRadio use_radio) {
  Cells cells = Cells::Zero(kSize, static_cast<Eigen::Index>(count));
  for (std::size_t j = 0; j < count; ++j) {
    const FeatureVector& cell = drive.cells[from + j];
    const auto column = static_cast<Eigen::Index>(j);
    for (std::size_t i = 0; i < kCellFeatures; ++i) {
      if (use_radio == UseRadio::kYes || !kCellFeatureTable[i].uses_radio) {
        cells(static_cast<Eigen::Index>(i), column) =
            (static_cast<double>(cell[i]) - scale.mean[i]) / scale.deviation[i];
      }
    }
    cells(kSize - 1, column) = 1.0;
  }
  return cells;
}

/// First and second derivatives of minus the log likelihood.
struct Derivatives {
  Vector gradient;
  Matrix curvature;
};

void addCells(const WeightedDrive& one, const Scale& scale, UseRadio use_radio,
              const Vector& weights, Derivatives& derivatives) {
  constexpr std::size_t kBlock = 1000;  // cells at once: products of matrices are fast
  const TrainingCells& drive = *one.drive;
  for (std::size_t from = 0; from < drive.cells.size(); from += kBlock) {
    const std::size_t count = std::min(kBlock, drive.cells.size() - from);
    const Cells cells = standardised(drive, from, count, scale, use_radio);
    const Eigen::ArrayXd p = (1.0 + (-(cells.transpose() * weights).array()).exp()).inverse();
    const Eigen::Map<const FreeCells> free(drive.free.data() + from,
                                           static_cast<Eigen::Index>(count));
    derivatives.gradient += cells * (one.weight * (p - free.cast<double>())).matrix();
    derivatives.curvature +=
        cells * (one.weight * p * (1.0 - p)).matrix().asDiagonal() * cells.transpose();
  }
}

/// Maximises the penalised likelihood. The penalty matters little to hundreds of thousands of
/// cells, but it keeps nearly equal features from large opposite weights.
BeliefModel::Weights regression(const std::vector<WeightedDrive>& training, const Scale& scale,
                                UseRadio use_radio) {
  constexpr int kIterations = 12;
  constexpr double kRidge = 100.0;
  Vector penalty = Vector::Constant(kRidge);
  penalty[kSize - 1] = 0.0;  // the intercept's
  Vector weights = Vector::Zero();
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    Derivatives derivatives{penalty.cwiseProduct(weights), penalty.asDiagonal()};
    for (const WeightedDrive& one : training) {
      addCells(one, scale, use_radio, weights, derivatives);
    }
    weights -= derivatives.curvature.ldlt().solve(derivatives.gradient);
  }
  BeliefModel::Weights result;
  result.intercept = weights[kSize - 1];
  for (std::size_t i = 0; i < kCellFeatures; ++i) {
    result.features[i] = weights[static_cast<Eigen::Index>(i)] / scale.deviation[i];
    result.intercept -= result.features[i] * scale.mean[i];
  }
  return result;
}

/// Fits the distribution of one style and leaves the weights at zero.
BeliefModel::Expert expertFor(DrivingStyle style, const std::vector<TrainingCells>& drives) {
  std::vector<BeliefModel::Style> styles;
  for (const TrainingCells& drive : drives) {
    if (drive.made == style) {
      styles.push_back(BeliefModel::styleVector(drive.style));
    }
  }
  constexpr std::size_t kLeastDrives = 5;  // for a covariance of three metrics
  if (styles.size() < kLeastDrives) {
    throw std::invalid_argument("a belief model needs five drives of each style; simulate more");
  }
  const auto count = static_cast<double>(styles.size());
  BeliefModel::Expert expert;
  for (const BeliefModel::Style& one : styles) {
    expert.style_mean += one / count;
  }
  // A small multiple of the unit matrix avoids a singular covariance with few or equal drives.
  expert.style_covariance = 1e-4 * Eigen::Matrix3d::Identity();
  for (const BeliefModel::Style& one : styles) {
    const BeliefModel::Style away = one - expert.style_mean;
    expert.style_covariance += away * away.transpose() / count;
  }
  return expert;
}

DriveData toDriveData(const TrainingDrive& drive) {
  DriveData data;
  std::map<Bssid, std::size_t> index;
  for (const AccessPoint& one : drive.access_points) {
    index[one.bssid] = data.access_points.size();
    data.access_points.push_back({one.position, one.height_m, {}});
  }
  for (const Reading& reading : drive.readings) {
    data.access_points[index.at(reading.bssid)].samples.push_back(
        {reading.antenna_in_map, reading.rssi_dbm});
    if (data.path.empty() || data.path.back() != reading.antenna_in_map) {
      data.path.push_back(reading.antenna_in_map);
    }
  }
  return data;
}

}  // namespace

TrainingCells drawTrainingCells(const TrainingDrive& drive, const Config& config, std::size_t count,
                                std::int64_t seed) {
  const std::atomic<bool> never{false};
  const DriveFeatures features = extractDriveFeatures(toDriveData(drive), config, never);
  const GridGeometry& geometry = features.cells.geometry;
  Random random(seed, streamOf(Purpose::kTrainingCells), 0);
  const double share =
      static_cast<double>(count) / static_cast<double>(features.cells.cells.size());
  TrainingCells training{drive.style, features.cells.style, {}, {}};
  for (std::size_t i = 0; i < features.cells.cells.size(); ++i) {
    if (random.uniform() > share) {
      continue;
    }
    const Position position =
        features.frame.toMap(geometry.centre(geometry.cell(features.cells.cells[i])));
    const Cell c = drive.truth.geometry.cellAt(position);
    const bool free = drive.truth.geometry.contains(c) && drive.truth[c] == CellState::kFree;
    training.cells.push_back(features.cells.values[i]);
    training.free.push_back(free ? 1 : 0);
  }
  return training;
}

BeliefModel fitBeliefModel(const std::vector<TrainingCells>& drives) {
  for (const TrainingCells& drive : drives) {
    if (drive.free.size() != drive.cells.size()) {
      throw std::invalid_argument("each training cell needs a state");
    }
  }
  std::array<BeliefModel::Expert, kDrivingStyles> experts;
  for (std::size_t i = 0; i < kDrivingStyles; ++i) {
    experts[i] = expertFor(static_cast<DrivingStyle>(i), drives);
  }
  const BeliefModel styles(experts);
  for (std::size_t i = 0; i < kDrivingStyles; ++i) {
    std::vector<WeightedDrive> training;
    for (const TrainingCells& drive : drives) {
      const double share = styles.shares(drive.style)[i];
      if (share > 0.0) {
        training.push_back({&drive, share});
      }
    }
    const Scale scale = scaleOf(training);
    experts[i].with_radio = regression(training, scale, UseRadio::kYes);
    experts[i].without_radio = regression(training, scale, UseRadio::kNo);
  }
  return BeliefModel(experts);
}

}  // namespace sfw
