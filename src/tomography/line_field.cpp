#include "tomography/line_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "grid/for_each_cell.h"
#include "tomography/line_rays.h"

namespace sfw {
namespace {

/// Changes along a wall are penalised by their size above this, quadratically below [dB].
constexpr double kSoftChange = 0.3;

/// Reweighting between the rounds: cells with strong neighbours get cheaper, lonely ones dearer.
constexpr std::int64_t kReweightAlong = 2;   // cells on each side
constexpr std::int64_t kReweightAcross = 1;  // cells on each side
constexpr float kReweightGain = 3.0F;
constexpr float kLeastWeight = 0.25F;
constexpr float kMostWeight = 2.0F;

constexpr int kPowerIterations = 15;

using Vector = Eigen::VectorXf;

/// What is heard of one access point: its share of all rays, and how far their signals agree.
struct Heard {
  Eigen::Index first_ray;
  Eigen::Index rays;
  SignalPrecisionF precision;
};

SignalPrecisionF precisionOf(const AccessPointBins& heard, const ShadowingModel& model) {
  std::vector<Position> places;
  std::vector<double> noise;
  std::vector<double> loss;
  for (const RadioBin& bin : heard.bins) {
    places.push_back(bin.place);
    noise.push_back(heard.noise_db2 / bin.readings);
    loss.push_back(logDistance(heard, bin.place));
  }
  return SignalPrecisionF(SignalPrecision(places, noise, loss, model));
}

class Solver {
 public:
  Solver(const std::vector<LineLattice>& lattices, const std::vector<AccessPointBins>& heard,
         const std::vector<Mask>& driven, const LineFieldConfig& config,
         const std::atomic<bool>& stop)
      : config_(config), stop_(stop), lattices_(lattices), rays_(lattices, heard, driven, stop) {
    hear(heard);
    const auto count = static_cast<Eigen::Index>(rays_.unknowns().size());
    continued_ = static_cast<float>(config.straightness) * rays_.unknowns().continued();
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
  void hear(const std::vector<AccessPointBins>& heard) {
    unexplained_.resize(static_cast<Eigen::Index>(rays_.size()));
    Eigen::Index ray = 0;
    for (const AccessPointBins& one : heard) {
      if (stop_) {
        return;
      }
      heard_.push_back(
          {ray, static_cast<Eigen::Index>(one.bins.size()), precisionOf(one, config_.shadowing)});
      for (const RadioBin& bin : one.bins) {
        const double expected = kPriorPower - kPriorExponent * logDistance(one, bin.place);
        unexplained_[ray++] = static_cast<float>(bin.rssi_dbm - expected);
      }
    }
  }

  bool saturates() const { return std::isfinite(config_.saturation_db); }

  /// What signals have less than expected, given the sums of losses on their rays.
  Vector residualOf(const Vector& sums) const {
    if (!saturates()) {
      return unexplained_ + sums;
    }
    const auto s = static_cast<float>(config_.saturation_db);
    return unexplained_.array() + s * (1.0F - (-sums.array() / s).exp());
  }

  /// Sets `pull` to Q r.
  void weigh(const Vector& residual, Vector& pull) const {
    pull.resize(residual.size());
    for (const Heard& one : heard_) {
      one.precision.times(residual.segment(one.first_ray, one.rays),
                          pull.segment(one.first_ray, one.rays));
    }
  }

  /// Sets `gradient_` to the derivative of the objective but for the sparsity term.
  void differentiateAt(const Vector& x) {
    rays_.along(x, sums_);
    weigh(residualOf(sums_), pull_);
    if (saturates()) {
      pull_.array() *= (-sums_.array() / static_cast<float>(config_.saturation_db)).exp();
    }
    rays_.spread(pull_, gradient_);
    addStraightness(x);
  }

  /// Pulls unknowns together that follow each other along a wall.
  void addStraightness(const Vector& x) {
    const Eigen::Index pairs = continued_.size();
    constexpr auto kSoft = static_cast<float>(kSoftChange * kSoftChange);
    change_ = x.tail(pairs) - x.head(pairs);
    change_ *= continued_ / (change_.square() + kSoft).sqrt();
    gradient_.tail(pairs).array() += change_;
    gradient_.head(pairs).array() -= change_;
  }

  /// No smaller than the largest curvature of the smooth part.
  float curvatureBound() {
    Vector x = Vector::Ones(loss_.size());
    float largest = 0.0F;
    for (int i = 0; i < kPowerIterations && !stop_; ++i) {
      rays_.along(x, sums_);
      weigh(sums_, pull_);
      rays_.spread(pull_, gradient_);
      largest = gradient_.norm() / std::max(x.norm(), 1e-12F);
      x = gradient_ / std::max(gradient_.norm(), 1e-12F);
    }
    return 1.05F * largest + static_cast<float>(4.0 * config_.straightness / kSoftChange);
  }

  void iterate(float bound) {
    const float step = 1.0F / bound;
    const Vector threshold = static_cast<float>(config_.sparsity) * step * weight_;
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

  /// The losses along a direction.
  template <class Field>
  static auto& gridOf(Field& field, const Unknowns::Direction& direction) {
    return direction.across_x ? field[direction.lattice].across_x
                              : field[direction.lattice].across_y;
  }

  void reweight() {
    const LineField found = field();
    rays_.unknowns().forEach([&](Eigen::Index i, const Unknowns::Direction& direction, Cell c) {
      const Grid<float>& loss = gridOf(found, direction);
      const std::int64_t reach_x = direction.across_x ? kReweightAcross : kReweightAlong;
      const std::int64_t reach_y = direction.across_x ? kReweightAlong : kReweightAcross;
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
  std::vector<Heard> heard_;
  Vector unexplained_;        // signals less those expected without walls [dB], by ray
  Eigen::ArrayXf continued_;  // straightness between an unknown and the next; 0 if it goes not on
  Vector loss_;
  Vector weight_;
  Vector sums_, pull_, gradient_;  // kept for their memory alone, as is this:
  Eigen::ArrayXf change_;
};

}  // namespace

LineField solveLineField(const std::vector<LineLattice>& lattices,
                         const std::vector<AccessPointBins>& heard, const std::vector<Mask>& driven,
                         const LineFieldConfig& config, const std::atomic<bool>& stop) {
  return Solver(lattices, heard, driven, config, stop).solve();
}

double lossBetween(const LineField& field, const Position& from, const Position& to) {
  double sum = 0.0;
  for (const LatticeLoss& loss : field) {
    forEachLine(loss.lattice.geometry, loss.lattice.toLattice(from), loss.lattice.toLattice(to),
                [&](bool across_x, Cell cell) {
                  sum += static_cast<double>((across_x ? loss.across_x : loss.across_y)[cell]);
                });
  }
  return sum;
}

}  // namespace sfw
