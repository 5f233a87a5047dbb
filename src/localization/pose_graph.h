#pragma once

#include <cstddef>
#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// The positions of a path [m], and by how much the heading of the odometry is wrong at each.
struct Trajectory {
  std::vector<Position> positions;
  std::vector<double> turns_rad;
};

/// What says that two positions of a path lie near one another.
struct LoopConstraint {
  std::size_t from = 0;                ///< index of the earlier position
  std::size_t to = 0;                  ///< index of the later one
  Position offset = Position::Zero();  ///< from the earlier to the later one [m], map frame
  double variance_m2 = 1.0;            ///< of each coordinate of the offset
};

/// Errors of odometry that grow as a random walk does. The defaults are those of a poor one.
struct OdometryNoise {
  double step_m = 0.07;    ///< standard deviation of a coordinate after 1 m
  double turn_rad = 0.05;  ///< standard deviation of the heading after 1 m
};

/// Bends a path so that it agrees with closings of loops.
///
/// This is a pose graph (Lu and Milios 1997): a chain of steps of the odometry, each turned by the
/// error of the heading, and closings between far parts of it. Wrong closings have little weight
/// (Cauchy's function). It is wide at first, so that right closings pull from afar too (graduated
/// non-convexity, Blake and Zisserman 1987). The first position stays, with its heading.
///
/// @param odometry  positions that only odometry tells [m]
/// @param start     where the search begins; as many positions as `odometry`
/// O(iterations x (positions + closings)) where few closings cross.
Trajectory optimizedTrajectory(const std::vector<Position>& odometry,
                               const std::vector<LoopConstraint>& closings,
                               const OdometryNoise& noise, const Trajectory& start);

/// The path of the odometry itself.
Trajectory odometryTrajectory(const std::vector<Position>& odometry);

/// Positions that follow the last of a trajectory by odometry alone.
/// @param odometry  all positions; those beyond `path` are appended to it
void extend(const std::vector<Position>& odometry, Trajectory& path);

/// Squared distance of a closing from a path, in units of its variance.
double squaredMisfit(const LoopConstraint& closing, const std::vector<Position>& positions);

/// Sum of the squared errors of steps and turns that a path says the odometry made, in units of
/// their variances.
double strainOf(const std::vector<Position>& odometry, const Trajectory& path,
                const OdometryNoise& noise);

}  // namespace sfw
