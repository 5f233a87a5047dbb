#include "stray_poses.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace sfw {
namespace {

constexpr double kFastest = 10.0;      // [m/s]
constexpr double kJump = 2.0;          // [m] that a correction of the path may move it by at once
constexpr double kLongestLost = 10.0;  // [s]

double seconds(const PathPose& from, const PathPose& to) {
  return 1e-9 * std::abs(static_cast<double>(to.stamp_ns) - static_cast<double>(from.stamp_ns));
}

/// Poses that follow each other without a jump.
struct Piece {
  std::size_t first;
  std::size_t last;
};

std::vector<Piece> piecesOf(const std::vector<PathPose>& path) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i > 0 && isReachable(path[i - 1], path[i])) {
      pieces.back().last = i;
    } else {
      pieces.push_back({i, i});
    }
  }
  return pieces;
}

}  // namespace

bool isReachable(const PathPose& from, const PathPose& to) {
  return (to.antenna_in_map - from.antenna_in_map).norm() <= kJump + kFastest * seconds(from, to);
}

std::vector<bool> strayPoses(const std::vector<PathPose>& path) {
  std::vector<bool> stray(path.size(), false);
  const std::vector<Piece> pieces = piecesOf(path);
  if (pieces.size() < 2) {
    return stray;
  }
  const auto most = std::max_element(
      pieces.begin(), pieces.end(),
      [](const Piece& a, const Piece& b) { return a.last - a.first < b.last - b.first; });
  const auto judge = [&](const Piece& piece, std::size_t believed, std::size_t near) {
    const bool lasts = seconds(path[piece.first], path[piece.last]) >= kLongestLost;
    if (lasts || isReachable(path[believed], path[near])) {
      return true;
    }
    for (std::size_t i = piece.first; i <= piece.last; ++i) {
      stray[i] = true;
    }
    return false;
  };
  std::size_t believed = most->last;
  for (auto piece = most + 1; piece != pieces.end(); ++piece) {
    believed = judge(*piece, believed, piece->first) ? piece->last : believed;
  }
  believed = most->first;
  for (auto piece = most; piece != pieces.begin();) {
    --piece;
    believed = judge(*piece, believed, piece->last) ? piece->first : believed;
  }
  return stray;
}

}  // namespace sfw
