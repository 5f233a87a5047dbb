#include "evaluation/cross_validation.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/limited_loss.h"
#include "files/mrpt_library.h"
#include "localization/signal_field.h"
#include "path/building_frame.h"
#include "radio/path_loss.h"
#include "radio/radio_bins.h"
#include "radio/shadowing.h"

namespace sfw {
namespace {

constexpr double kMaxGap = 1.0;      // [m] between readings; longer pieces are no heading
constexpr double kGrid = 0.1;        // [m]; half the bins
constexpr double kGridMargin = 0.5;  // [m]
constexpr std::int64_t kMostCells = 16'000'000;
constexpr std::size_t kFewestBins = 8;
constexpr std::array<double, 4> kKernelsM{0.5, 1.0, 2.0, 4.0};  // of MRPT

/// One access point in a fold.
struct Part {
  AccessPointBins known;
  AccessPointBins hidden;
};

/// Signals at some bins, with the inputs of their prediction.
struct Bins {
  Eigen::VectorXd signals;    // [dBm], walls' losses added back
  Eigen::VectorXd wall_loss;  // [dB]
  Eigen::MatrixXd basis;      // one, 10 log10 of distance
};

/// Fold of each reading.
std::vector<int> foldsOf(const std::vector<Reading>& readings, const PredictionConfig& config) {
  std::vector<int> folds;
  double way = 0.0;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    way += i > 0 ? (readings[i].antenna_in_map - readings[i - 1].antenna_in_map).norm() : 0.0;
    folds.push_back(static_cast<int>(std::fmod(std::floor(way / config.stretch_m), config.folds)));
  }
  return folds;
}

double rootMeanSquare(double sum, std::size_t count) {
  return std::sqrt(sum / static_cast<double>(count));
}

/// The log-distance law fitted to bins: power and exponent.
Eigen::Vector2d lawOf(const AccessPointBins& access_point, const Bins& bins,
                      const SignalCovariance& model) {
  const ShadowingWhitener whitener(access_point, model);
  const Eigen::MatrixXd white = whitener.whitened(bins.basis);
  const Eigen::Vector2d prior(kPriorPowerDbm, -kPriorExponent);
  const Eigen::Vector2d deviation(model.power_sd_db, model.exponent_sd);
  Eigen::Matrix2d information = white.transpose() * white;
  information.diagonal() += deviation.cwiseAbs2().cwiseInverse();
  return prior + information.llt().solve(white.transpose() *
                                         (whitener.whitened(bins.signals) - white * prior));
}

/// The signals at bins, as samples in the building frame.
std::vector<Sample> samplesOf(const AccessPointBins& access_point, const Eigen::VectorXd& signals) {
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < access_point.bins.size(); ++i) {
    samples.push_back({access_point.bins[i].position, signals[static_cast<Eigen::Index>(i)]});
  }
  return samples;
}

/// Sums of squared errors of one way to predict [dB2].
struct SquaredErrors {
  double mean = 0.0;      ///< without shadowing
  double shadowed = 0.0;  ///< with the signals of the nearest bins
};

class Prediction {
 public:
  Prediction(std::vector<Reading> readings, const std::vector<AccessPoint>& access_points,
             const PredictionConfig& config)
      : readings_(std::move(readings)), access_points_(access_points), config_(config) {
    std::stable_sort(readings_.begin(), readings_.end(),
                     [](const Reading& a, const Reading& b) { return a.stamp_ns < b.stamp_ns; });
    std::vector<Position> path;
    for (const Reading& reading : readings_) {
      path.push_back(reading.antenna_in_map);
    }
    frame_ = findBuildingFrame(path, kMaxGap);
  }

  std::optional<PredictionMetrics> metrics(const std::atomic<bool>& stop) {
    const std::optional<GridGeometry> geometry = grid();
    if (!geometry) {
      return std::nullopt;
    }
    Mask path(*geometry);
    for (const Reading& reading : readings_) {
      path[geometry->cellAt(frame_.toBuilding(reading.antenna_in_map))] = 1;
    }
    const std::vector<int> folds = foldsOf(readings_, config_);
    for (int fold = 0; fold < config_.folds && !stop; ++fold) {
      predict(path, partsOf(folds, fold), stop);
    }
    if (stop || bins_ == 0) {
      return std::nullopt;
    }
    return PredictionMetrics{
        bins_,
        rootMeanSquare(distance_.mean, bins_),
        rootMeanSquare(walls_.mean, bins_),
        rootMeanSquare(distance_.shadowed, bins_),
        rootMeanSquare(walls_.shadowed, bins_),
        rootMeanSquare(kriging_db2_, bins_),
        rootMeanSquare(*std::min_element(mrpt_db2_.begin(), mrpt_db2_.end()), bins_)};
  }

 private:
  std::optional<GridGeometry> grid() const {
    Box box;
    for (const Reading& reading : readings_) {
      box.extend(frame_.toBuilding(reading.antenna_in_map));
    }
    for (const AccessPoint& access_point : access_points_) {
      box.extend(frame_.toBuilding(access_point.position));
    }
    if (readings_.empty()) {
      return std::nullopt;
    }
    const Position margin(kGridMargin, kGridMargin);
    const Box wide(box.min() - margin, box.max() + margin);
    if (!(wide.sizes().prod() < static_cast<double>(kMostCells) / 2.0 * kGrid * kGrid)) {
      return std::nullopt;
    }
    return GridGeometry::covering(wide, kGrid, kGridMargin, kMostCells);
  }

  std::vector<Part> partsOf(const std::vector<int>& folds, int fold) const {
    std::vector<Part> parts;
    for (const AccessPoint& access_point : access_points_) {
      std::vector<Sample> known;
      std::vector<Sample> hidden;
      for (std::size_t i = 0; i < readings_.size(); ++i) {
        if (readings_[i].bssid == access_point.bssid) {
          (folds[i] == fold ? hidden : known)
              .push_back({readings_[i].antenna_in_map, readings_[i].rssi_dbm});
        }
      }
      const auto binned = [&](const std::vector<Sample>& samples) {
        return binSamples(samples, access_point.position, access_point.height_m, frame_,
                          config_.bin_size_m);
      };
      Part part{binned(known), binned(hidden)};
      if (part.known.bins.size() >= kFewestBins && !part.hidden.bins.empty()) {
        parts.push_back(std::move(part));
      }
    }
    return parts;
  }

  void predict(const Mask& path, const std::vector<Part>& parts, const std::atomic<bool>& stop) {
    std::vector<AccessPointBins> known;
    known.reserve(parts.size());
    for (const Part& part : parts) {
      known.push_back(part.known);
    }
    const WallField field =
        estimateWalls(path.geometry, known, path, config_.robot_radius_m, config_.walls, stop);
    for (const Part& part : parts) {
      add(part, nullptr, distance_);
      add(part, &field, walls_);
      const std::vector<Sample> known_means =
          samplesOf(part.known, describe(part.known, nullptr).signals);
      const std::vector<Position> places = positionsOf(part.hidden);
      const SignalField kriging(known_means, learnConstantLaw(known_means));
      addErrors(part.hidden, kriging.predict(places).mean_dbm, kriging_db2_);
      for (std::size_t i = 0; i < kKernelsM.size(); ++i) {
        addErrors(part.hidden, mrptFunctions().predictSignals(known_means, places, kKernelsM[i]),
                  mrpt_db2_[i]);
      }
      bins_ += part.hidden.bins.size();
    }
  }

  Bins describe(const AccessPointBins& access_point, const WallField* field) const {
    const auto count = static_cast<Eigen::Index>(access_point.bins.size());
    Bins bins{Eigen::VectorXd(count), Eigen::VectorXd::Zero(count), Eigen::MatrixXd(count, 2)};
    for (Eigen::Index i = 0; i < count; ++i) {
      const RadioBin& bin = access_point.bins[static_cast<std::size_t>(i)];
      if (field != nullptr) {
        bins.wall_loss[i] = limitedLoss(lossBetween(*field, access_point.position, bin.position),
                                        config_.walls.line.max_total_wall_loss_db);
      }
      bins.signals[i] = bin.rssi_dbm + bins.wall_loss[i];
      bins.basis.row(i) << 1.0, logDistance(access_point, bin.position);
    }
    return bins;
  }

  void add(const Part& part, const WallField* field, SquaredErrors& sum) const {
    const Bins known = describe(part.known, field);
    const Bins hidden = describe(part.hidden, field);
    sum.mean +=
        (hidden.signals - hidden.basis * lawOf(part.known, known, config_.shadowing)).squaredNorm();
    const std::vector<Sample> samples = samplesOf(part.known, known.signals);
    const SignalField shadowed(samples, learnSignalLaw(samples, part.known.position));
    const std::vector<double> predicted_dbm = shadowed.predict(positionsOf(part.hidden)).mean_dbm;
    for (Eigen::Index i = 0; i < hidden.signals.size(); ++i) {
      const double error_db = hidden.signals[i] - predicted_dbm[static_cast<std::size_t>(i)];
      sum.shadowed += error_db * error_db;
    }
  }

  static void addErrors(const AccessPointBins& hidden, const std::vector<double>& predicted_dbm,
                        double& sum_db2) {
    for (std::size_t i = 0; i < predicted_dbm.size(); ++i) {
      const double error_db = hidden.bins[i].rssi_dbm - predicted_dbm[i];
      sum_db2 += error_db * error_db;
    }
  }

  std::vector<Reading> readings_;
  const std::vector<AccessPoint>& access_points_;
  const PredictionConfig& config_;
  BuildingFrame frame_;
  SquaredErrors distance_;
  SquaredErrors walls_;
  double kriging_db2_ = 0.0;  // sums of squared errors
  std::array<double, kKernelsM.size()> mrpt_db2_{};
  std::size_t bins_ = 0;
};

}  // namespace

PredictionConfig::PredictionConfig() {
  walls.ensemble_size = 4;
  walls.line.max_total_wall_loss_db = 15.0;
  walls.line.covariance.nugget_db2 = 9.0;
  shadowing.shadowing_db = 3.5;
  shadowing.shadowing_distance_m = 1.0;
  shadowing.nugget_db2 = 4.0;
}

std::optional<PredictionMetrics> predictHiddenStretches(
    const std::vector<Reading>& readings, const std::vector<AccessPoint>& access_points,
    const PredictionConfig& config, const std::atomic<bool>& stop) {
  return Prediction(readings, access_points, config).metrics(stop);
}

}  // namespace sfw
