#pragma once

#include <cstdint>
#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// A random function of position, close to Gaussian, with mean 0 and standard deviation 1 over
/// seeds.
///
/// The field is a sum of plane waves with random phases. Their wave numbers and directions fill the
/// spectrum evenly rather than by chance. So one field alone has the stated correlation, not only
/// the mean of many fields. Immutable.
class RandomField {
 public:
  /// The form of the correlation of two positions over their distance d. Both forms are 1/e at the
  /// length.
  enum class Kind {
    kRough,  ///< exp(-d / length), the usual form for shadowing (Gudmundson 1991)
    kSmooth  ///< exp(-(d / length)^2), without detail far below the length
  };

  /// @param length_m  finite and positive
  /// @param stream    a number for each field of one seed
  RandomField(Kind kind, double length_m, std::int64_t seed, std::uint64_t stream);

  /// The value at a position [m], which must be finite. O(waves), 128 cosines.
  double at(const Position& place) const;

 private:
  struct Wave {
    Position rad_per_m;
    double phase_rad;
  };

  std::vector<Wave> waves_;
};

}  // namespace sfw
