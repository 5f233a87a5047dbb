#pragma once

#include <cmath>

namespace sfw {

/// Natural logarithm of the odds p / (1 - p) of a probability between 0 and 1, both excluded.
inline double logit(double probability) { return std::log(probability / (1.0 - probability)); }

/// Probability whose log odds are `x`, in the precision of `x`: the inverse of logit().
template <class T>
T logistic(T x) {
  return T{1} / (T{1} + std::exp(-x));
}

}  // namespace sfw
