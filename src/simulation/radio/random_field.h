#pragma once

#include <cstdint>
#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// A random function of place, close to Gaussian, with mean 0 and standard deviation 1 over seeds.
///
/// A sum of plane waves with random phases. Their wave numbers and directions fill the field's
/// spectrum evenly rather than by chance, so that already one field, not only the mean of many,
/// has the stated correlation. Immutable.
class RandomField {
 public:
  /// How the correlation of two places falls with their distance d; 1/e at the length either way.
  enum class Kind {
    kRough,  ///< exp(-d / length), the usual form for shadowing (Gudmundson 1991)
    kSmooth  ///< exp(-(d / length)^2), without detail far below the length
  };

  /// @param length_m  finite and positive
  /// @param stream    tells fields of one seed apart
  RandomField(Kind kind, double length_m, std::int64_t seed, std::uint64_t stream);

  /// @param place  finite [m]. O(waves), 128 cosines.
  double at(const Position& place) const;

 private:
  struct Wave {
    Position rad_per_m;
    double phase_rad;
  };

  std::vector<Wave> waves_;
};

}  // namespace sfw
