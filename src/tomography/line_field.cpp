#include "tomography/line_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "grid/for_each_cell.h"
#include "radio/path_loss.h"
#include "radio/shadowing.h"
#include "tomography/line_rays.h"

namespace sfw {
namespace {

/// Changes along a wall are penalised by their size above this, quadratically below [dB].
constexpr double kSoftChange = 0.3;

/// Reweighting between the rounds: the L1 weight falls beside strong walls and rises elsewhere.
constexpr std::int64_t kReweightAlong = 2;   // cells on each side
constexpr std::int64_t kReweightAcross = 1;  // cells on each side
constexpr float kReweightGain = 3.0F;
constexpr float kLeastWeight = 0.25F;
constexpr float kMostWeight = 2.0F;

constexpr int kPowerIterations = 15;

using Vector = Eigen::VectorXf;

/// The rays of one access point among all rays, and the inverse covariance of their signals.
struct AccessPointRays {
  Eigen::Index first_ray;
  Eigen::Index rays;
  SignalPrecisionF precision;
};

class Solver {
 public:
  Solver(const std::vector<LineLattice>& lattices,
         const std::vector<AccessPointBins>& access_points, const std::vector<Mask>& driven,
         const LineFieldConfig& config, const std::atomic<bool>& stop)
      : config_(config),
        stop_(stop),
        lattices_(lattices),
        rays_(lattices, access_points, driven, stop) {
    enter(access_points);
    const auto count = static_cast<Eigen::Index>(rays_.unknowns().size());
    continued_ = static_cast<float>(config.smoothness_weight) * rays_.unknowns().continued();
    loss_ = Vector::Zero(count);
    weight_ = Vector::Ones(count);
  }

  LineField solve() {
    if (loss_.size() > 0) {
      const float bound = curvatureBound();
      iterate(bound);
      reweight();
      iterate(bound);
    }
    return field();
  }

 private:
  void enter(const std::vector<AccessPointBins>& access_points) {
    excess_.resize(static_cast<Eigen::Index>(rays_.size()));
    Eigen::Index ray = 0;
    for (const AccessPointBins& one : access_points) {
      if (stop_) {
        return;
      }
      access_points_.push_back({ray, static_cast<Eigen::Index>(one.bins.size()),
                                SignalPrecisionF(SignalPrecision(one, config_.covariance))});
      for (const RadioBin& bin : one.bins) {
        const double expected = kPriorPowerDbm - kPriorExponent * logDistance(one, bin.position);
        excess_[ray++] = static_cast<float>(bin.rssi_dbm - expected);
      }
    }
  }

  bool lossesAreLimited() const { return std::isfinite(config_.max_total_wall_loss_db); }

  /// Residuals of the signals, given the sums of losses on their rays [dB].
  Vector residualOf(const Vector& sums) const {
    if (!lossesAreLimited()) {
      return excess_ + sums;
    }
    const auto s = static_cast<float>(config_.max_total_wall_loss_db);
    return excess_.array() + s * (1.0F - (-sums.array() / s).exp());
  }

  /// Sets `pull` to Q r.
  void applyPrecision(const Vector& residual, Vector& pull) const {
    pull.resize(residual.size());
    for (const AccessPointRays& one : access_points_) {
      one.precision.times(residual.segment(one.first_ray, one.rays),
                          pull.segment(one.first_ray, one.rays));
    }
  }

  /// Sets `gradient_` to the derivative of the objective without the L1 term.
  void differentiateAt(const Vector& x) {
    rays_.along(x, sums_);
    applyPrecision(residualOf(sums_), pull_);
    if (lossesAreLimited()) {
      pull_.array() *= (-sums_.array() / static_cast<float>(config_.max_total_wall_loss_db)).exp();
    }
    rays_.spread(pull_, gradient_);
    addSmoothness(x);
  }

  /// Adds the derivative of the penalty for changes along a wall.
  void addSmoothness(const Vector& x) {
    const Eigen::Index pairs = continued_.size();
    constexpr auto kSoft = static_cast<float>(kSoftChange * kSoftChange);
    change_ = x.tail(pairs) - x.head(pairs);
    change_ *= continued_ / (change_.square() + kSoft).sqrt();
    gradient_.tail(pairs).array() += change_;
    gradient_.head(pairs).array() -= change_;
  }

  /// An upper bound of the largest curvature of the smooth part.
  float curvatureBound() {
    Vector x = Vector::Ones(loss_.size());
    float largest = 0.0F;
    for (int i = 0; i < kPowerIterations && !stop_; ++i) {
      rays_.along(x, sums_);
      applyPrecision(sums_, pull_);
      rays_.spread(pull_, gradient_);
      largest = gradient_.norm() / std::max(x.norm(), 1e-12F);
      x = gradient_ / std::max(gradient_.norm(), 1e-12F);
    }
    return 1.05F * largest + static_cast<float>(4.0 * config_.smoothness_weight / kSoftChange);
  }

  void iterate(float bound) {
    const float step = 1.0F / bound;
    const Vector threshold = static_cast<float>(config_.l1_weight) * step * weight_;
    Vector ahead = loss_;
    Vector moved;
    double momentum = 1.0;
    for (int i = 0; i < config_.iterations && !stop_; ++i) {
      differentiateAt(ahead);
      moved = (ahead - step * gradient_ - threshold).cwiseMax(0.0F);
      const double next = 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * momentum * momentum));
      ahead = moved + static_cast<float>((momentum - 1.0) / next) * (moved - loss_);
      loss_.swap(moved);
      momentum = next;
    }
  }

  /// The losses of the walls in one direction.
  template <class Field>
  static auto& gridOf(Field& field, const Unknowns::Direction& direction) {
    return direction.walls_along_y ? field[direction.lattice].walls_along_y
                                   : field[direction.lattice].walls_along_x;
  }

  void reweight() {
    const LineField found = field();
    rays_.unknowns().forEach([&](Eigen::Index i, const Unknowns::Direction& direction, Cell c) {
      const Grid<float>& loss = gridOf(found, direction);
      const std::int64_t reach_x = direction.walls_along_y ? kReweightAcross : kReweightAlong;
      const std::int64_t reach_y = direction.walls_along_y ? kReweightAlong : kReweightAcross;
      float sum = 0.0F;
      forEachCell({c.x - reach_x, c.y - reach_y}, {c.x + reach_x, c.y + reach_y},
                  [&](Cell at) { sum += loss.geometry.contains(at) ? loss[at] : 0.0F; });
      constexpr auto kCells =
          static_cast<float>((2 * kReweightAlong + 1) * (2 * kReweightAcross + 1));
      weight_[i] =
          std::clamp(2.0F / (1.0F + kReweightGain * sum / kCells), kLeastWeight, kMostWeight);
    });
  }

  LineField field() const {
    LineField field(lattices_.begin(), lattices_.end());
    rays_.unknowns().forEach([&](Eigen::Index i, const Unknowns::Direction& direction, Cell c) {
      gridOf(field, direction)[c] = loss_[i];
    });
    return field;
  }

  const LineFieldConfig& config_;
  const std::atomic<bool>& stop_;
  const std::vector<LineLattice>& lattices_;
  Rays rays_;
  std::vector<AccessPointRays> access_points_;
  Vector excess_;             // signals less those expected without walls [dB], by ray
  Eigen::ArrayXf continued_;  // weight of the change to the next unknown; 0 at the end of a wall
  Vector loss_;
  Vector weight_;
  Vector sums_, pull_, gradient_;  // only their memory is kept from call to call, as for this:
  Eigen::ArrayXf change_;
};

}  // namespace

LineField solveLineField(const std::vector<LineLattice>& lattices,
                         const std::vector<AccessPointBins>& access_points,
                         const std::vector<Mask>& driven, const LineFieldConfig& config,
                         const std::atomic<bool>& stop) {
  return Solver(lattices, access_points, driven, config, stop).solve();
}

double lossBetween(const LineField& field, const Position& from, const Position& to) {
  double sum = 0.0;
  for (const LatticeLoss& loss : field) {
    forEachLine(loss.lattice.geometry, loss.lattice.toLattice(from), loss.lattice.toLattice(to),
                [&](bool walls_along_y, Cell cell) {
                  sum += static_cast<double>(
                      (walls_along_y ? loss.walls_along_y : loss.walls_along_x)[cell]);
                });
  }
  return sum;
}

}  // namespace sfw
