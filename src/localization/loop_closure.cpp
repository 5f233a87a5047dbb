#include "localization/loop_closure.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "base/median.h"
#include "localization/particle_filter.h"
#include "localization/radio_map.h"
#include "localization/scan.h"
#include "localization/scan_difference.h"

namespace sfw {
namespace {

constexpr std::int64_t kScanNs = 500'000'000;
constexpr double kStretchM = 0.5;  // of the way that one pose of the graph stands for

constexpr double kBlockM = 15.0;      // of the way that is localised on one radio map
constexpr double kMostBlocks = 24.0;  // so the blocks of a long drive are longer
constexpr double kApartM = 5.0;       // of the way between a radio map and the block
constexpr double kWarmUpM = 5.0;      // of the way before a block, for the filter to settle

constexpr double kNearM = 2.0;             // from a closing to a mapped place
constexpr double kSharedErrors = 4.0;      // closings of neighbouring stretches count as one
constexpr double kLeastVarianceM2 = 0.01;  // of an estimate, even if all particles agree

/// The estimate of the filter nearest to the middle of a stretch.
struct StretchEstimate {
  double away_m = std::numeric_limits<double>::infinity();  ///< of its scan from the middle
  Position position = Position::Zero();                     ///< of the middle [m]
  double variance_m2 = 0.0;                                 ///< of each coordinate
};

/// The limits were chosen on simulated drives (doc/results/drift.md).
LoopClosure::Finding findingOf(const LoopClosure& loop) {
  constexpr std::size_t kFewestClosings = 10;
  constexpr double kAgree = 0.7;       // [sigma]
  constexpr double kMostStrain = 0.6;  // for each metre
  // A path without drift bends to the errors of the closings. That alone halves their misfit.
  constexpr double kGain = 3.0;
  if (loop.closings < kFewestClosings) {
    return LoopClosure::Finding::kNoLoop;
  }
  if (loop.before.in_sigmas < kGain * loop.after.in_sigmas) {
    return LoopClosure::Finding::kNoDrift;
  }
  const bool agrees = loop.after.in_sigmas < kAgree && loop.strain_per_m < kMostStrain;
  return agrees ? LoopClosure::Finding::kDrift : LoopClosure::Finding::kContradicts;
}

/// Closes loops block by block. The path is optimized after each block.
class LoopCloser {
 public:
  LoopCloser(const std::vector<Reading>& readings, std::int64_t seed, const std::atomic<bool>* stop)
      : scans_(scansOf(readings, kScanNs)),
        stretches_(stretchesOf(readings, kStretchM)),
        way_m_(wayOf(stretches_)),
        difference_(stretches_),
        same_place_db2_(difference_.usualOfNeighbours(stretches_)),
        stop_(stop) {
    filter_config_.seed = seed;
    filter_config_.start_yaw = 0.5;  // the path is corrected up to the block
    for (const Scan& stretch : stretches_) {
      loop_.stamps_ns.push_back(stretch.stamp_ns);
      loop_.odometry.push_back(stretch.position);
    }
    loop_.path = odometryTrajectory(loop_.odometry);
    for (const Scan& scan : scans_) {
      stretch_of_.push_back(stretchAt(scan.stamp_ns));
    }
  }

  LoopClosure run() {
    // Two strengths belong to two places at least, and noise makes them many.
    constexpr std::size_t kFewestRadios = 4;
    if (!scans_.empty() && difference_.radios() < kFewestRadios) {
      loop_.finding = LoopClosure::Finding::kFewRadios;
      return std::move(loop_);
    }
    const double whole_m = way_m_.empty() ? 0.0 : way_m_.back();
    const double block_m = std::max(kBlockM, whole_m / kMostBlocks);
    for (double from_m = 2.0 * kBlockM; from_m < whole_m && !isStopped(stop_); from_m += block_m) {
      addClosings(from_m, from_m + block_m);
      optimizeUpTo(from_m + block_m);
    }
    summarise();
    return std::move(loop_);
  }

 private:
  void addClosings(double from_m, double to_m) {
    const std::vector<StretchEstimate> estimates = estimatesOf(from_m, to_m);
    const auto mapped = static_cast<std::size_t>(
        std::lower_bound(way_m_.begin(), way_m_.end(), from_m - kApartM) - way_m_.begin());
    for (std::size_t i = mapped; i < estimates.size(); ++i) {
      if (std::isinf(estimates[i].away_m) || !soundsMapped(i, mapped)) {
        continue;
      }
      const auto distance = [&](std::size_t other) {
        return (loop_.path.positions[other] - estimates[i].position).norm();
      };
      std::size_t nearest = 0;
      for (std::size_t j = 1; j < mapped; ++j) {
        nearest = distance(j) < distance(nearest) ? j : nearest;
      }
      if (distance(nearest) < kNearM) {
        closings_.push_back({nearest, i, estimates[i].position - loop_.path.positions[nearest],
                             kSharedErrors * std::max(estimates[i].variance_m2, kLeastVarianceM2)});
      }
    }
  }

  /// Whether a stretch sounds like one of the first `mapped` ones as neighbours do.
  bool soundsMapped(std::size_t stretch, std::size_t mapped) const {
    for (std::size_t i = 0; i < mapped; ++i) {
      if (difference_.between(stretch, i) <= same_place_db2_) {
        return true;
      }
    }
    return false;
  }

  /// Localises the scans of a block on the radio map of the way before it.
  /// @return for each stretch
  std::vector<StretchEstimate> estimatesOf(double from_m, double to_m) const {
    std::vector<StretchEstimate> estimates(stretches_.size());
    std::vector<Scan> mapped;
    std::size_t i = 0;
    for (; i < scans_.size() && wayAt(i) < from_m - kApartM; ++i) {
      mapped.push_back(scans_[i]);
      mapped.back().position = loop_.moved(scans_[i].stamp_ns, scans_[i].position);
    }
    RadioMap::Config config;
    config.layers.stop = stop_;
    const RadioMap map(mapped, {}, config);
    ParticleFilter filter(map, filter_config_);
    const Scan* before = nullptr;
    for (; i < scans_.size() && wayAt(i) < to_m; ++i) {
      if (wayAt(i) < from_m - kWarmUpM) {
        continue;
      }
      const Scan& scan = scans_[i];
      const std::size_t at = stretch_of_[i];
      const Eigen::Rotation2Dd turn(loop_.path.turns_rad[at]);
      const auto step = before == nullptr
                            ? std::nullopt
                            : std::optional<Position>(turn * (scan.position - before->position));
      before = &scan;
      const std::optional<PlaceEstimate> place = filter.add(scan, step);
      const Position to_middle = stretches_[at].position - scan.position;
      if (place && wayAt(i) >= from_m && to_middle.norm() < estimates[at].away_m) {
        estimates[at] = {to_middle.norm(), place->position + turn * to_middle,
                         0.5 * place->covariance.trace()};
      }
    }
    return estimates;
  }

  /// Way at a scan. Noise of its position does not lengthen the way of the stretches.
  double wayAt(std::size_t scan) const { return way_m_[stretch_of_[scan]]; }

  /// The stretch of a time.
  std::size_t stretchAt(std::int64_t stamp_ns) const {
    const auto after = std::upper_bound(loop_.stamps_ns.begin(), loop_.stamps_ns.end(), stamp_ns);
    return static_cast<std::size_t>(
        std::max<std::ptrdiff_t>(std::distance(loop_.stamps_ns.begin(), after) - 1, 0));
  }

  /// Optimizes the path up to some way; the rest follows as it is.
  void optimizeUpTo(double way_m) {
    if (closings_.empty()) {
      return;
    }
    const auto count = std::lower_bound(way_m_.begin(), way_m_.end(), way_m) - way_m_.begin();
    const std::vector<Position> odometry(loop_.odometry.begin(), loop_.odometry.begin() + count);
    Trajectory start = loop_.path;
    start.positions.resize(odometry.size());
    start.turns_rad.resize(odometry.size());
    loop_.path = optimizedTrajectory(odometry, closings_, {}, start);
    extend(loop_.odometry, loop_.path);
  }

  void summarise() {
    loop_.closings = closings_.size();
    if (closings_.empty()) {
      return;
    }
    loop_.before = misfitOf(loop_.odometry);
    loop_.after = misfitOf(loop_.path.positions);
    loop_.strain_per_m = strainOf(loop_.odometry, loop_.path, {}) / way_m_.back();
    for (std::size_t i = 0; i < loop_.odometry.size(); ++i) {
      loop_.farthest_moved_m =
          std::max(loop_.farthest_moved_m, (loop_.path.positions[i] - loop_.odometry[i]).norm());
    }
    loop_.finding = findingOf(loop_);
  }

  LoopClosure::Misfit misfitOf(const std::vector<Position>& positions) const {
    std::vector<double> distances_m;
    std::vector<double> sigmas;
    for (const LoopConstraint& closing : closings_) {
      const double squares = squaredMisfit(closing, positions);
      distances_m.push_back(std::sqrt(squares * closing.variance_m2));
      sigmas.push_back(std::sqrt(squares));
    }
    const double by_chance = std::sqrt(2.0 * std::log(2.0));  // median of Rayleigh's distribution
    return {median(std::move(distances_m)), median(std::move(sigmas)) / by_chance};
  }

  std::vector<Scan> scans_;
  std::vector<Scan> stretches_;
  std::vector<double> way_m_;
  std::vector<std::size_t> stretch_of_;  // of each scan
  ScanDifference difference_;
  double same_place_db2_;
  const std::atomic<bool>* stop_;
  ParticleFilter::Config filter_config_;
  LoopClosure loop_;
  std::vector<LoopConstraint> closings_;
};

}  // namespace

Position LoopClosure::moved(std::int64_t stamp_ns, const Position& point) const {
  if (stamps_ns.empty()) {
    return point;
  }
  const auto movedWith = [&](std::size_t i) -> Position {
    return path.positions[i] + Eigen::Rotation2Dd(path.turns_rad[i]) * (point - odometry[i]);
  };
  const auto later = std::upper_bound(stamps_ns.begin(), stamps_ns.end(), stamp_ns);
  if (later == stamps_ns.begin() || later == stamps_ns.end()) {
    return movedWith(later == stamps_ns.begin() ? 0 : stamps_ns.size() - 1);
  }
  const auto next = static_cast<std::size_t>(later - stamps_ns.begin());
  const double share = static_cast<double>(stamp_ns - stamps_ns[next - 1]) /
                       static_cast<double>(stamps_ns[next] - stamps_ns[next - 1]);
  return (1.0 - share) * movedWith(next - 1) + share * movedWith(next);
}

LoopClosure closeLoops(const std::vector<Reading>& readings, std::int64_t seed,
                       const std::atomic<bool>* stop) {
  return LoopCloser(readings, seed, stop).run();
}

std::map<std::string, LoopClosure> closeLoopsByRobot(const std::vector<Reading>& readings,
                                                     std::int64_t seed,
                                                     const std::atomic<bool>* stop) {
  std::map<std::string, std::vector<Reading>> by_robot;
  for (const Reading& reading : readings) {
    by_robot[reading.robot].push_back(reading);
  }
  std::map<std::string, LoopClosure> loops;
  for (const auto& [robot, own] : by_robot) {
    loops[robot] = closeLoops(own, seed, stop);
  }
  return loops;
}

}  // namespace sfw
