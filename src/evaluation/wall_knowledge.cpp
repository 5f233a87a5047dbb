#include "evaluation/wall_knowledge.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/random.h"
#include "base/random_streams.h"
#include "evaluation/samples.h"
#include "grid/morphology.h"
#include "radio/nearest_neighbours.h"

namespace sfw {
namespace {

constexpr double kPlace = 0.2;        // [m] edge of the square of a place
constexpr double kNearest = 0.5;      // [m] between the places of a pair
constexpr double kFarthest = 3.0;     // [m] between the places of a pair
constexpr double kLeastWall = 1.0;    // [m] across
constexpr double kPathInTruth = 0.1;  // [m] from the path, no wall stands
constexpr double kPathInMaps = 0.15;  // [m] from the path, no map is asked for a wall

/// The places by column and row of their squares.
using Places = std::map<std::pair<std::int64_t, std::int64_t>, Position>;

bool isBefore(const Position& a, const Position& b) {
  return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
}

Places placesOf(const std::vector<Position>& path) {
  const auto square = [](double coordinate) {
    return static_cast<std::int64_t>(std::floor(coordinate / kPlace));
  };
  Places places;
  for (const Position& position : path) {
    const auto [known, is_new] =
        places.try_emplace({square(position.x()), square(position.y())}, position);
    if (!is_new && isBefore(position, known->second)) {
      known->second = position;
    }
  }
  return places;
}

/// Calls `visit(from, to)` for each pair of places within reach, in a fixed order.
template <class Visitor>
void forEachPair(const Places& places, Visitor&& visit) {
  const auto reach = static_cast<std::int64_t>(std::ceil(kFarthest / kPlace));
  for (auto from = places.begin(); from != places.end(); ++from) {
    const auto [x, y] = from->first;
    for (std::int64_t column = x; column <= x + reach; ++column) {
      auto to = column == x ? std::next(from) : places.lower_bound({column, y - reach});
      for (; to != places.end() && to->first <= std::pair(column, y + reach); ++to) {
        const double apart = (from->second - to->second).norm();
        if (apart > kNearest && apart <= kFarthest) {
          visit(from->second, to->second);
        }
      }
    }
  }
}

/// Occupied cells without the small parts.
Mask wallsOf(const Grid<CellState>& truth) {
  const Components parts =
      labelComponents(cellsOfState(truth, CellState::kOccupied), Connectivity::kEdgesAndCorners);
  std::vector<Box> boxes(static_cast<std::size_t>(parts.count) + 1);  // of cells
  forEachCell(truth.geometry, [&](Cell c) {
    boxes[static_cast<std::size_t>(parts.label[c])].extend(
        Position(static_cast<double>(c.x), static_cast<double>(c.y)));
  });
  Mask walls(truth.geometry);
  forEachCell(truth.geometry, [&](Cell c) {
    const std::int64_t label = parts.label[c];
    if (label != 0) {
      const double cells = boxes[static_cast<std::size_t>(label)].sizes().maxCoeff() + 1.0;
      walls[c] = cells * truth.geometry.resolution() < kLeastWall ? 0 : 1;
    }
  });
  return walls;
}

Position pointBetween(const Position& from, const Position& to, std::size_t sample) {
  const double t = static_cast<double>(sample) / static_cast<double>(PlacePairs::kSamples - 1);
  return (1.0 - t) * from + t * to;
}

}  // namespace

/// The distance to the nearest position of the path [m].
class PlacePairs::DistanceToPath {
 public:
  explicit DistanceToPath(std::vector<Position> path)
      : path_(withoutRepeats(std::move(path))), neighbours_(path_) {
    for (std::size_t i = 0; i < path_.size(); ++i) {
      neighbours_.enter(static_cast<int>(i));
    }
  }

  double operator()(const Position& point) {
    return std::sqrt(neighbours_.nearest(point, 1).front().first);
  }

 private:
  static std::vector<Position> withoutRepeats(std::vector<Position> path) {
    std::sort(path.begin(), path.end(), isBefore);
    path.erase(std::unique(path.begin(), path.end()), path.end());
    return path;
  }

  std::vector<Position> path_;
  NearestNeighbours neighbours_;
};

PlacePairs::PlacePairs(const Grid<CellState>& truth, const std::vector<Position>& path,
                       std::size_t most) {
  Random random(0, streamOf(Purpose::kEvaluatedPlaces), 0);
  std::size_t found = 0;
  // Reservoir sampling (Vitter 1985, algorithm R): each pair has the same chance to stay.
  const Places places = placesOf(path);
  forEachPair(places, [&](const Position& from, const Position& to) {
    ++found;
    if (pairs_.size() < most) {
      pairs_.push_back({from, to, false, {}});
      return;
    }
    const auto drawn =
        static_cast<std::size_t>(std::ceil(random.uniform(0.0, static_cast<double>(found)))) - 1;
    if (drawn < most) {
      pairs_[drawn] = {from, to, false, {}};
    }
  });
  const Mask walls = wallsOf(truth);
  DistanceToPath to_path(path);
  for (Pair& pair : pairs_) {
    lookAt(pair, walls, to_path);
  }
}

void PlacePairs::lookAt(Pair& pair, const Mask& walls, DistanceToPath& to_path) {
  const double step = (pair.to - pair.from).norm() / static_cast<double>(kSamples - 1);
  double distance = 0.0;  // of the last point that was asked; the first one is on the path
  double moved = 0.0;     // since then
  for (std::size_t i = 0; i < kSamples; ++i, moved += step) {
    const Position point = pointBetween(pair.from, pair.to, i);
    // A distance changes by no more than the way moved, so most points need no search.
    if (distance - moved <= kPathInMaps && distance + moved >= kPathInTruth) {
      distance = to_path(point);
      moved = 0.0;
    }
    pair.beside[i] = distance - moved > kPathInMaps;
    pair.wall |= distance - moved > kPathInTruth && valueAt<std::uint8_t>(walls, point, 0) != 0;
  }
}

std::size_t PlacePairs::walls() const {
  return static_cast<std::size_t>(
      std::count_if(pairs_.begin(), pairs_.end(), [](const Pair& pair) { return pair.wall; }));
}

WallKnowledge PlacePairs::knowledgeOf(const Grid<CellState>& map,
                                      const std::optional<Grid<float>>& probabilities) const {
  double called = 0.0;
  double right = 0.0;
  for (const Pair& pair : pairs_) {
    if (callsWall(map, pair)) {
      called += 1.0;
      right += pair.wall ? 1.0 : 0.0;
    }
  }
  WallKnowledge knowledge;
  knowledge.precision = called > 0.0 ? right / called : 0.0;
  const auto standing = static_cast<double>(walls());
  if (standing > 0.0) {
    knowledge.recall = right / standing;
    knowledge.f1 = 2.0 * right / (called + standing);
  }
  if (probabilities) {
    knowledge.auc = areaUnderCurve(rate(*probabilities));
  }
  return knowledge;
}

bool PlacePairs::callsWall(const Grid<CellState>& map, const Pair& pair) const {
  for (std::size_t i = 0; i < kSamples; ++i) {
    if (pair.beside[i] && valueAt(map, pointBetween(pair.from, pair.to, i), CellState::kUnknown) !=
                              CellState::kFree) {
      return true;
    }
  }
  return false;
}

Ratings PlacePairs::rate(const Grid<float>& probabilities) const {
  constexpr float kUndecided = 0.5F;
  Ratings ratings;
  for (const Pair& pair : pairs_) {
    float greatest = 0.0F;
    for (std::size_t i = 0; i < kSamples; ++i) {
      if (pair.beside[i]) {
        const float p = valueAt(probabilities, pointBetween(pair.from, pair.to, i), kUndecided);
        greatest = std::max(greatest, p >= 0.0F && p <= 1.0F ? p : kUndecided);
      }
    }
    (pair.wall ? ratings.wall : ratings.free).push_back(static_cast<double>(greatest));
  }
  return ratings;
}

}  // namespace sfw
