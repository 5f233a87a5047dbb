#include "structure_from_wifi/line_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "line_rays.h"

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

class Solver {
 public:
  Solver(const GridGeometry& geometry, const std::vector<HeardAccessPoint>& heard,
         const Mask& driven, const LineFieldConfig& config, const std::atomic<bool>& stop)
      : geometry_(geometry), config_(config), stop_(stop), unknowns_(geometry, driven) {
    for (const HeardAccessPoint& one : heard) {
      rays_.emplace_back(geometry, one, config.shadowing, unknowns_);
    }
    const auto count = static_cast<Eigen::Index>(unknowns_.cells().size());
    for (const Unknowns::Place& place : unknowns_.cells()) {
      const std::int32_t next = unknowns_.find(place.direction, Unknowns::along(place, 1));
      if (next != Unknowns::kNone) {
        neighbours_.push_back({unknowns_.find(place.direction, place.cell), next});
      }
    }
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
    LineField field(geometry_);
    for (std::size_t i = 0; i < unknowns_.cells().size(); ++i) {
      const Unknowns::Place& place = unknowns_.cells()[i];
      (place.direction == Direction::kAcrossX ? field.across_x : field.across_y)[place.cell] =
          loss_[static_cast<Eigen::Index>(i)];
    }
    return field;
  }

 private:
  /// Unknowns of which the second continues the first one's wall.
  struct Neighbours {
    std::int32_t one;
    std::int32_t next;
  };

  bool saturates() const { return std::isfinite(config_.saturation_db); }

  Eigen::VectorXd residualOf(const Rays& rays, const Eigen::VectorXd& sums) const {
    if (!saturates()) {
      return rays.unexplained() + sums;
    }
    const double s = config_.saturation_db;
    return rays.unexplained().array() + s * (1.0 - (-sums.array() / s).exp());
  }

  /// Derivative of the objective but for the sparsity term.
  Vector gradientAt(const Vector& x) const {
    Vector gradient = Vector::Zero(x.size());
    for (const Rays& rays : rays_) {
      const Eigen::VectorXd sums = rays.along(x);
      Eigen::VectorXd pull = rays.precision().times(residualOf(rays, sums));
      if (saturates()) {
        pull.array() *= (-sums.array() / config_.saturation_db).exp();
      }
      rays.spread(pull, gradient);
    }
    addStraightness(x, gradient);
    return gradient;
  }

  /// Pulls cells together that follow each other along a wall. In three passes, of which the
  /// expensive one runs on several changes at once.
  void addStraightness(const Vector& x, Vector& gradient) const {
    Eigen::ArrayXf pull(static_cast<Eigen::Index>(neighbours_.size()));
    Eigen::Index at = 0;
    for (const Neighbours& pair : neighbours_) {
      pull[at++] = x[pair.next] - x[pair.one];
    }
    constexpr auto kSoft = static_cast<float>(kSoftChange * kSoftChange);
    pull *= static_cast<float>(config_.straightness) / (pull.square() + kSoft).sqrt();
    at = 0;
    for (const Neighbours& pair : neighbours_) {
      gradient[pair.next] += pull[at];
      gradient[pair.one] -= pull[at++];
    }
  }

  /// No smaller than the largest curvature of the smooth part.
  float curvatureBound() const {
    Vector x = Vector::Ones(loss_.size());
    float largest = 0.0F;
    for (int i = 0; i < kPowerIterations && !stop_; ++i) {
      Vector image = Vector::Zero(x.size());
      for (const Rays& rays : rays_) {
        rays.spread(rays.precision().times(rays.along(x)), image);
      }
      largest = image.norm() / std::max(x.norm(), 1e-12F);
      x = image / std::max(image.norm(), 1e-12F);
    }
    return 1.05F * largest + static_cast<float>(4.0 * config_.straightness / kSoftChange);
  }

  void iterate(float bound) {
    Vector ahead = loss_;
    double momentum = 1.0;
    const auto sparsity = static_cast<float>(config_.sparsity);
    for (int i = 0; i < config_.iterations && !stop_; ++i) {
      const Vector moved =
          (ahead - (gradientAt(ahead) + sparsity * weight_) / bound).cwiseMax(0.0F);
      const double next = 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * momentum * momentum));
      ahead = moved + static_cast<float>((momentum - 1.0) / next) * (moved - loss_);
      loss_ = moved;
      momentum = next;
    }
  }

  void reweight() {
    for (std::size_t i = 0; i < unknowns_.cells().size(); ++i) {
      const Unknowns::Place& place = unknowns_.cells()[i];
      float sum = 0.0F;
      for (std::int64_t across = -kReweightAcross; across <= kReweightAcross; ++across) {
        const Unknowns::Place row{place.direction, Unknowns::across(place, across)};
        for (std::int64_t along = -kReweightAlong; along <= kReweightAlong; ++along) {
          const std::int32_t id = unknowns_.find(place.direction, Unknowns::along(row, along));
          sum += id == Unknowns::kNone ? 0.0F : loss_[id];
        }
      }
      constexpr auto kCells =
          static_cast<float>((2 * kReweightAlong + 1) * (2 * kReweightAcross + 1));
      weight_[static_cast<Eigen::Index>(i)] =
          std::clamp(2.0F / (1.0F + kReweightGain * sum / kCells), kLeastWeight, kMostWeight);
    }
  }

  const GridGeometry& geometry_;
  const LineFieldConfig& config_;
  const std::atomic<bool>& stop_;
  Unknowns unknowns_;
  std::vector<Rays> rays_;
  std::vector<Neighbours> neighbours_;
  Vector loss_;
  Vector weight_;
};

}  // namespace

LineField solveLineField(const GridGeometry& geometry, const std::vector<HeardAccessPoint>& heard,
                         const Mask& driven, const LineFieldConfig& config,
                         const std::atomic<bool>& stop) {
  return Solver(geometry, heard, driven, config, stop).solve();
}

double lossBetween(const LineField& field, const Position& from, const Position& to) {
  const GridGeometry& geometry = field.across_x.geometry;
  double loss = 0.0;
  forEachLine(geometry, from, to, [&](bool across_x, Cell cell) {
    loss += static_cast<double>((across_x ? field.across_x : field.across_y)[cell]);
  });
  return loss;
}

}  // namespace sfw
