#include "localization/pose_graph.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "base/constants.h"

namespace sfw {
namespace {

constexpr double kOutlier = 4.0;  // misfit at which a closing has half of its weight

/// The derivative of a residual by a coordinate of a pose: x, y or the turn.
struct Derivative {
  std::size_t pose;
  int coordinate;
  double value;
};

/// The normal equations of small changes of all poses but the first, which stays.
class NormalEquations {
 public:
  explicit NormalEquations(std::size_t poses)
      : size_(3 * static_cast<Eigen::Index>(poses - 1)), right_(Eigen::VectorXd::Zero(size_)) {}

  void add(double residual, double weight, std::initializer_list<Derivative> derivatives) {
    for (const Derivative& one : derivatives) {
      if (one.pose == 0) {
        continue;
      }
      right_[variable(one)] -= weight * one.value * residual;
      for (const Derivative& other : derivatives) {
        if (other.pose > 0) {
          left_.emplace_back(variable(one), variable(other), weight * one.value * other.value);
        }
      }
    }
  }

  /// The changes of x, y and turn of the second pose, the third and so on.
  Eigen::VectorXd solve() const {
    Eigen::SparseMatrix<double> left(size_, size_);
    left.setFromTriplets(left_.begin(), left_.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(left);
    return solver.solve(right_);
  }

 private:
  static Eigen::Index variable(const Derivative& derivative) {
    return 3 * static_cast<Eigen::Index>(derivative.pose - 1) + derivative.coordinate;
  }

  Eigen::Index size_;
  std::vector<Eigen::Triplet<double>> left_;
  Eigen::VectorXd right_;
};

/// Variances of a step of the odometry.
struct StepNoise {
  double position_m2, turn_rad2;
};

StepNoise noiseOf(const Position& step, const OdometryNoise& noise) {
  constexpr double kLeastWay = 0.005;  // [m]; standing still, odometry is good but not perfect
  const double way_m = std::max(step.norm(), kLeastWay);
  return {noise.step_m * noise.step_m * way_m, noise.turn_rad * noise.turn_rad * way_m};
}

/// The error that a path says a step of the odometry has.
Position errorOfStep(const std::vector<Position>& odometry, std::size_t i, const Trajectory& path) {
  return path.positions[i + 1] - path.positions[i] -
         Eigen::Rotation2Dd(path.turns_rad[i]) * (odometry[i + 1] - odometry[i]);
}

void addSteps(const std::vector<Position>& odometry, const OdometryNoise& noise,
              const Trajectory& path, NormalEquations& equations) {
  for (std::size_t i = 0; i + 1 < odometry.size(); ++i) {
    const Position step = odometry[i + 1] - odometry[i];
    const Position by_turn = Eigen::Rotation2Dd(path.turns_rad[i] + 0.5 * kPi) * step;
    const Position error = errorOfStep(odometry, i, path);
    const StepNoise variance = noiseOf(step, noise);
    for (int axis = 0; axis < 2; ++axis) {
      equations.add(error[axis], 1.0 / variance.position_m2,
                    {{i + 1, axis, 1.0}, {i, axis, -1.0}, {i, 2, -by_turn[axis]}});
    }
    equations.add(path.turns_rad[i + 1] - path.turns_rad[i], 1.0 / variance.turn_rad2,
                  {{i + 1, 2, 1.0}, {i, 2, -1.0}});
  }
}

/// @param width  of Cauchy's function, in units of kOutlier
void addClosings(const std::vector<LoopConstraint>& closings, double width, const Trajectory& path,
                 NormalEquations& equations) {
  for (const LoopConstraint& closing : closings) {
    const Position error =
        path.positions[closing.to] - path.positions[closing.from] - closing.offset;
    const double weight =
        1.0 /
        (closing.variance_m2 * (1.0 + squaredMisfit(closing, path.positions) / (kOutlier * width)));
    for (int axis = 0; axis < 2; ++axis) {
      equations.add(error[axis], weight, {{closing.to, axis, 1.0}, {closing.from, axis, -1.0}});
    }
  }
}

/// Takes a step of Gauss and Newton.
/// @return its largest change [m or rad]
double improve(const std::vector<Position>& odometry, const std::vector<LoopConstraint>& closings,
               const OdometryNoise& noise, double width, Trajectory& path) {
  NormalEquations equations(odometry.size());
  addSteps(odometry, noise, path, equations);
  addClosings(closings, width, path, equations);
  const Eigen::VectorXd change = equations.solve();
  for (std::size_t i = 1; i < odometry.size(); ++i) {
    const auto at = 3 * static_cast<Eigen::Index>(i - 1);
    path.positions[i] += change.segment<2>(at);
    path.turns_rad[i] += change[at + 2];
  }
  return change.size() > 0 ? change.cwiseAbs().maxCoeff() : 0.0;
}

}  // namespace

double squaredMisfit(const LoopConstraint& closing, const std::vector<Position>& positions) {
  return (positions[closing.to] - positions[closing.from] - closing.offset).squaredNorm() /
         closing.variance_m2;
}

double strainOf(const std::vector<Position>& odometry, const Trajectory& path,
                const OdometryNoise& noise) {
  double strain = 0.0;
  for (std::size_t i = 0; i + 1 < odometry.size(); ++i) {
    const StepNoise variance = noiseOf(odometry[i + 1] - odometry[i], noise);
    const double turn_rad = path.turns_rad[i + 1] - path.turns_rad[i];
    strain += errorOfStep(odometry, i, path).squaredNorm() / variance.position_m2 +
              turn_rad * turn_rad / variance.turn_rad2;
  }
  return strain;
}

Trajectory odometryTrajectory(const std::vector<Position>& odometry) {
  return {odometry, std::vector<double>(odometry.size(), 0.0)};
}

void extend(const std::vector<Position>& odometry, Trajectory& path) {
  while (path.positions.size() < odometry.size()) {
    const std::size_t next = path.positions.size();
    const double turn_rad = next > 0 ? path.turns_rad.back() : 0.0;
    path.positions.push_back(next > 0
                                 ? path.positions.back() + Eigen::Rotation2Dd(turn_rad) *
                                                               (odometry[next] - odometry[next - 1])
                                 : odometry[next]);
    path.turns_rad.push_back(turn_rad);
  }
}

Trajectory optimizedTrajectory(const std::vector<Position>& odometry,
                               const std::vector<LoopConstraint>& closings,
                               const OdometryNoise& noise, const Trajectory& start) {
  constexpr double kWidest = 20.0;
  constexpr double kNarrower = 0.6;
  constexpr int kMostSteps = 30;
  constexpr double kSmallChange = 1e-4;  // [m or rad]
  Trajectory path = start;
  double width = kWidest;
  for (int step = 0; step < kMostSteps; ++step) {
    const double change = improve(odometry, closings, noise, width, path);
    if (width == 1.0 && change < kSmallChange) {
      break;
    }
    width = std::max(1.0, kNarrower * width);
  }
  return path;
}

}  // namespace sfw
