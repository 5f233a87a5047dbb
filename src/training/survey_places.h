#pragma once

#include <cstddef>
#include <vector>

#include "base/random.h"
#include "training/training_drive.h"

namespace sfw {

/// The places of a survey on a lattice, and the straight ways between neighbours. Immutable.
class SurveyPlaces {
 public:
  /// Chooses spacing, offset and clearance of the lattice at random and leaves out a few places.
  /// O(places x length of ways).
  SurveyPlaces(const FloorPlan& plan, Random& random);

  const Position& position(std::size_t place) const { return positions_[place]; }  ///< [m]

  /// The walk of a survey through the largest connected set of places, or a part of it.
  /// @return numbers of places; some come up again on the way to others. Empty without places.
  /// O(places^2).
  std::vector<std::size_t> walk(Random& random) const;

 private:
  std::vector<std::size_t> largestConnectedSet() const;
  std::vector<std::size_t> reachableFrom(std::size_t start) const;
  std::vector<std::size_t> wayToNearest(std::size_t start, const Position& heading,
                                        const std::vector<bool>& visited) const;

  std::vector<Position> positions_;
  std::vector<std::vector<std::size_t>> neighbours_;  // of each place
};

}  // namespace sfw
