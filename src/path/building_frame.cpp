#include "path/building_frame.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

#include "base/constants.h"

namespace sfw {
namespace {

/// Pieces are long enough that the jitter of a pose hardly turns them.
constexpr double kPiece = 0.4;  // [m]

/// Random headings reach a concentration of about 1/sqrt(pieces). Below this limit headings are no
/// evidence.
constexpr double kLeastConcentration = 0.15;
constexpr double kRefinement = 8.0 * kPi / 180.0;

/// An area has no long side if the ratio of its axes is below this value.
constexpr double kLeastElongation = 1.3;

/// Maps an angle to [-pi/4, pi/4), because quarter turns look alike.
double quarterTurn(double yaw_rad) {
  const double turned = yaw_rad - 0.5 * kPi * std::floor(yaw_rad / (0.5 * kPi) + 0.5);
  return turned < 0.25 * kPi ? turned : turned - 0.5 * kPi;
}

std::vector<Position> piecesOf(const std::vector<Position>& path, double max_gap_m) {
  std::vector<Position> pieces;
  if (path.empty()) {
    return pieces;
  }
  Position from = path.front();
  Position last = path.front();
  for (const Position& position : path) {
    if ((position - last).norm() > max_gap_m) {
      from = position;
    } else if ((position - from).norm() >= kPiece) {
      pieces.emplace_back(position - from);
      from = position;
    }
    last = position;
  }
  return pieces;
}

std::optional<double> yawOfHeadings(const std::vector<Position>& pieces) {
  std::complex<double> sum = 0.0;
  double weight = 0.0;
  for (const Position& piece : pieces) {
    const double length = piece.norm();
    sum += std::polar(length, 4.0 * std::atan2(piece.y(), piece.x()));
    weight += length;
  }
  if (weight == 0.0 || std::abs(sum) < kLeastConcentration * weight) {
    return std::nullopt;
  }
  const double yaw = std::arg(sum) / 4.0;
  double offset = 0.0;
  double near = 0.0;
  for (const Position& piece : pieces) {
    const double off = quarterTurn(std::atan2(piece.y(), piece.x()) - yaw);
    if (std::abs(off) < kRefinement) {
      offset += piece.norm() * off;
      near += piece.norm();
    }
  }
  return near > 0.0 ? yaw + offset / near : yaw;
}

std::optional<double> yawOfSpread(const std::vector<Position>& path) {
  if (path.size() < 2) {
    return std::nullopt;
  }
  Position mean = Position::Zero();
  for (const Position& position : path) {
    mean += position / static_cast<double>(path.size());
  }
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Position& position : path) {
    spread += (position - mean) * (position - mean).transpose();
  }
  const double difference = spread(0, 0) - spread(1, 1);
  const double cross = 2.0 * spread(0, 1);
  const double axes = std::hypot(difference, cross);
  const double trace = spread.trace();
  const double ratio = std::sqrt((trace + axes) / std::max(trace - axes, 1e-9));
  if (!(axes > 0.0) || ratio < kLeastElongation) {
    return std::nullopt;
  }
  return 0.5 * std::atan2(cross, difference);
}

}  // namespace

BuildingFrame findBuildingFrame(const std::vector<Position>& path, double max_gap_m) {
  if (const std::optional<double> yaw = yawOfHeadings(piecesOf(path, max_gap_m))) {
    return {quarterTurn(*yaw), BuildingFrame::Source::kHeadings};
  }
  if (const std::optional<double> yaw = yawOfSpread(path)) {
    return {quarterTurn(*yaw), BuildingFrame::Source::kSpread};
  }
  return {};
}

}  // namespace sfw
