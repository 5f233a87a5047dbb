#include "structure_from_wifi/line_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

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

/// The direction that rays cross a wall in.
enum class Direction { kAcrossX, kAcrossY };

/// The unknowns: cells that some ray crosses and no robot has covered, in both directions.
class Unknowns {
 public:
  Unknowns(const GridGeometry& geometry, const Mask& driven)
      : geometry_(geometry),
        driven_(driven),
        id_{Grid<std::int32_t>(geometry, kNone), Grid<std::int32_t>(geometry, kNone)} {}

  static constexpr std::int32_t kNone = -1;

  /// The unknown of a cell, made if need be; kNone if there cannot be one.
  std::int32_t at(Direction direction, Cell cell) {
    if (!geometry_.contains(cell) || driven_[cell] != 0) {
      return kNone;
    }
    std::int32_t& id = ids(direction)[cell];
    if (id == kNone) {
      id = static_cast<std::int32_t>(cells_.size());
      cells_.push_back({direction, cell});
    }
    return id;
  }

  std::int32_t find(Direction direction, Cell cell) const {
    return geometry_.contains(cell) ? ids(direction)[cell] : kNone;
  }

  struct Place {
    Direction direction;
    Cell cell;
  };
  const std::vector<Place>& cells() const { return cells_; }

  /// The next cell along the wall that an unknown is part of.
  static Cell along(const Place& place, std::int64_t step) {
    return place.direction == Direction::kAcrossX ? Cell{place.cell.x, place.cell.y + step}
                                                  : Cell{place.cell.x + step, place.cell.y};
  }
  static Cell across(const Place& place, std::int64_t step) {
    return place.direction == Direction::kAcrossX ? Cell{place.cell.x + step, place.cell.y}
                                                  : Cell{place.cell.x, place.cell.y + step};
  }

 private:
  Grid<std::int32_t>& ids(Direction direction) { return id_[static_cast<std::size_t>(direction)]; }
  const Grid<std::int32_t>& ids(Direction direction) const {
    return id_[static_cast<std::size_t>(direction)];
  }

  const GridGeometry& geometry_;
  const Mask& driven_;
  Grid<std::int32_t> id_[2];
  std::vector<Place> cells_;
};

/// One access point's rays: the unknowns that each crosses, and what is heard at its end.
struct Rays {
  Rays(const GridGeometry& geometry, const HeardAccessPoint& heard, const ShadowingModel& model,
       Unknowns& unknowns)
      : begin{0}, precision(precisionOf(heard, model)) {
    unexplained.resize(static_cast<Eigen::Index>(heard.bins.size()));
    for (std::size_t i = 0; i < heard.bins.size(); ++i) {
      const RadioBin& bin = heard.bins[i];
      forEachLine(geometry, heard.position, bin.place, [&](bool across_x, Cell cell) {
        const std::int32_t id =
            unknowns.at(across_x ? Direction::kAcrossX : Direction::kAcrossY, cell);
        if (id != Unknowns::kNone) {
          crossed.push_back(id);
        }
      });
      begin.push_back(crossed.size());
      const double loss = logDistance(heard, bin.place);
      unexplained[static_cast<Eigen::Index>(i)] =
          bin.rssi_dbm - (kPriorPower - kPriorExponent * loss);
    }
  }

  static SignalPrecision precisionOf(const HeardAccessPoint& heard, const ShadowingModel& model) {
    std::vector<Position> places;
    std::vector<double> noise;
    std::vector<double> loss;
    for (const RadioBin& bin : heard.bins) {
      places.push_back(bin.place);
      noise.push_back(heard.noise_db2 / bin.readings);
      loss.push_back(logDistance(heard, bin.place));
    }
    return {places, noise, loss, model};
  }

  std::size_t size() const { return begin.size() - 1; }

  /// Sum of `x` over the cells that each ray crosses.
  Eigen::VectorXd along(const Vector& x) const {
    Eigen::VectorXd sums(static_cast<Eigen::Index>(size()));
    for (std::size_t ray = 0; ray < size(); ++ray) {
      float sum = 0.0F;
      for (std::size_t i = begin[ray]; i < begin[ray + 1]; ++i) {
        sum += x[crossed[i]];
      }
      sums[static_cast<Eigen::Index>(ray)] = static_cast<double>(sum);
    }
    return sums;
  }

  /// Adds each ray's value to the cells that it crosses.
  void spread(const Eigen::VectorXd& values, Vector& sums) const {
    for (std::size_t ray = 0; ray < size(); ++ray) {
      const auto value = static_cast<float>(values[static_cast<Eigen::Index>(ray)]);
      for (std::size_t i = begin[ray]; i < begin[ray + 1]; ++i) {
        sums[crossed[i]] += value;
      }
    }
  }

  std::vector<std::size_t> begin;     // of each ray in `crossed`, and the end
  std::vector<std::int32_t> crossed;  // unknowns
  SignalPrecision precision;
  Eigen::VectorXd unexplained;  // signal less the prior's [dB]
};

class Solver {
 public:
  Solver(const GridGeometry& geometry, const std::vector<HeardAccessPoint>& heard,
         const Mask& driven, const LineFieldConfig& config, const std::atomic<bool>& stop)
      : geometry_(geometry), config_(config), stop_(stop), unknowns_(geometry, driven) {
    for (const HeardAccessPoint& one : heard) {
      rays_.emplace_back(geometry, one, config.shadowing, unknowns_);
    }
    const auto count = static_cast<Eigen::Index>(unknowns_.cells().size());
    next_.reserve(unknowns_.cells().size());
    for (const Unknowns::Place& place : unknowns_.cells()) {
      next_.push_back(unknowns_.find(place.direction, Unknowns::along(place, 1)));
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
  bool saturates() const { return std::isfinite(config_.saturation_db); }

  Eigen::VectorXd residualOf(const Rays& rays, const Eigen::VectorXd& sums) const {
    if (!saturates()) {
      return rays.unexplained + sums;
    }
    const double s = config_.saturation_db;
    return rays.unexplained.array() + s * (1.0 - (-sums.array() / s).exp());
  }

  /// Derivative of the objective but for the sparsity term.
  Vector gradientAt(const Vector& x) const {
    Vector gradient = Vector::Zero(x.size());
    for (const Rays& rays : rays_) {
      const Eigen::VectorXd sums = rays.along(x);
      Eigen::VectorXd pull = rays.precision.times(residualOf(rays, sums));
      if (saturates()) {
        pull.array() *= (-sums.array() / config_.saturation_db).exp();
      }
      rays.spread(pull, gradient);
    }
    const auto straightness = static_cast<float>(config_.straightness);
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const std::int32_t next = next_[static_cast<std::size_t>(i)];
      if (next != Unknowns::kNone) {
        const float change = x[next] - x[i];
        const float pull =
            straightness * change /
            std::sqrt(change * change + static_cast<float>(kSoftChange * kSoftChange));
        gradient[next] += pull;
        gradient[i] -= pull;
      }
    }
    return gradient;
  }

  /// No smaller than the largest curvature of the smooth part.
  float curvatureBound() const {
    Vector x = Vector::Ones(loss_.size());
    float largest = 0.0F;
    for (int i = 0; i < kPowerIterations && !stop_; ++i) {
      Vector image = Vector::Zero(x.size());
      for (const Rays& rays : rays_) {
        rays.spread(rays.precision.times(rays.along(x)), image);
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
  std::vector<std::int32_t> next_;  // the unknown that continues each one's wall
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
    if (geometry.contains(cell)) {
      loss += static_cast<double>((across_x ? field.across_x : field.across_y)[cell]);
    }
  });
  return loss;
}

}  // namespace sfw
