#pragma once

#include <bitset>
#include <cstddef>
#include <optional>
#include <vector>

#include "evaluation/area_under_curve.h"
#include "grid/mask.h"
#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Measures whether a map knows that a wall stands between two places of the path.
struct WallKnowledge {
  double precision = 0.0;  ///< share of the walls called that stand there; 0 if there are none
  std::optional<double> recall;  ///< share of the standing walls that are called
  std::optional<double> f1;      ///< harmonic mean of the two
  std::optional<double> auc;     ///< of the greatest probability between them; ties count half
};

/// Pairs of places of a path, and whether a wall stands between them in truth.
///
/// It does not matter where between the places a map draws a wall. A place is the first position in
/// the order of x, then y, within each square of 0.2 m. A pair lies over 0.5 m and up to 3 m apart.
/// Of more than `most` pairs, that many are drawn at random, by a fixed seed.
///
/// A line between two places is looked at in kSamples points.
/// In truth, a wall stands there if a point farther than 0.1 m from the path lies on an occupied
/// cell. Occupied parts less than 1 m across, such as legs of furniture, do not count.
/// A map calls a wall if a point farther than 0.15 m from the path lies on a cell that is not free.
class PlacePairs {
 public:
  static constexpr std::size_t kSamples = 121;

  /// @param path  positions [m], finite and below 1000 km; their order does not matter
  /// @param most  pairs
  /// O(cells of the truth + pairs of places).
  PlacePairs(const Grid<CellState>& truth, const std::vector<Position>& path, std::size_t most);

  std::size_t count() const { return pairs_.size(); }

  /// The number of pairs with a wall between them.
  std::size_t walls() const;

  /// @param probabilities  of being occupied; values not in [0, 1] count as 0.5
  /// O(count()).
  WallKnowledge knowledgeOf(const Grid<CellState>& map,
                            const std::optional<Grid<float>>& probabilities) const;

 private:
  struct Pair {
    Position from;
    Position to;
    bool wall = false;             // in truth
    std::bitset<kSamples> beside;  // points that lie farther than 0.15 m from the path
  };

  class DistanceToPath;

  static void lookAt(Pair& pair, const Mask& walls, DistanceToPath& to_path);
  bool callsWall(const Grid<CellState>& map, const Pair& pair) const;
  Ratings rate(const Grid<float>& probabilities) const;

  std::vector<Pair> pairs_;
};

}  // namespace sfw
