#include "path/stray_poses.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/median.h"

namespace sfw {
namespace {

constexpr double kFaster = 5.0;        // times the usual speed
constexpr double kSlow = 2.0;          // [m/s], a speed that any robot may reach
constexpr double kJump = 2.0;          // [m], by which a correction may move the path at once
constexpr double kLongestLost = 10.0;  // [s]

double seconds(const PathPose& from, const PathPose& to) {
  return 1e-9 * std::abs(static_cast<double>(to.stamp_ns) - static_cast<double>(from.stamp_ns));
}

/// Poses that follow each other without a jump.
struct Piece {
  std::size_t first;
  std::size_t last;
};

std::vector<Piece> piecesOf(const std::vector<PathPose>& path, double usual_speed_mps) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i > 0 && isReachable(path[i - 1], path[i], usual_speed_mps)) {
      pieces.back().last = i;
    } else {
      pieces.push_back({i, i});
    }
  }
  return pieces;
}

}  // namespace

double usualSpeed(const std::vector<PathPose>& path) {
  constexpr double kMoves = 0.01;  // [m]
  std::vector<double> speeds;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double distance = (path[i].antenna_in_map - path[i - 1].antenna_in_map).norm();
    if (distance > kMoves && path[i].stamp_ns != path[i - 1].stamp_ns) {
      speeds.push_back(distance / seconds(path[i - 1], path[i]));
    }
  }
  if (speeds.empty()) {
    return 0.0;
  }
  return median(std::move(speeds));
}

bool isReachable(const PathPose& from, const PathPose& to, double usual_speed_mps) {
  const double fastest = std::max(kSlow, kFaster * usual_speed_mps);
  return (to.antenna_in_map - from.antenna_in_map).norm() <= kJump + fastest * seconds(from, to);
}

std::vector<bool> strayPoses(const std::vector<PathPose>& path) {
  std::vector<bool> stray(path.size(), false);
  const double usual_speed_mps = usualSpeed(path);
  const std::vector<Piece> pieces = piecesOf(path, usual_speed_mps);
  if (pieces.size() < 2) {
    return stray;
  }
  const auto most = std::max_element(
      pieces.begin(), pieces.end(),
      [](const Piece& a, const Piece& b) { return a.last - a.first < b.last - b.first; });
  const auto keep = [&](const Piece& piece, std::size_t kept, std::size_t nearest) {
    const bool lasts = seconds(path[piece.first], path[piece.last]) >= kLongestLost;
    if (lasts || isReachable(path[kept], path[nearest], usual_speed_mps)) {
      return true;
    }
    for (std::size_t i = piece.first; i <= piece.last; ++i) {
      stray[i] = true;
    }
    return false;
  };
  std::size_t kept = most->last;
  for (auto piece = most + 1; piece != pieces.end(); ++piece) {
    kept = keep(*piece, kept, piece->first) ? piece->last : kept;
  }
  kept = most->first;
  for (auto piece = most; piece != pieces.begin();) {
    --piece;
    kept = keep(*piece, kept, piece->last) ? piece->first : kept;
  }
  return stray;
}

}  // namespace sfw
