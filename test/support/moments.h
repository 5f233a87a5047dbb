#pragma once

#include <cmath>
#include <vector>

namespace sfw::test {

/// Mean and standard deviation.
struct Moments {
  double mean = 0.0;
  double deviation = 0.0;
};

inline Moments momentsOf(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  double sum = 0.0, squares = 0.0;
  for (const double value : values) {
    sum += value;
  }
  for (const double value : values) {
    squares += (value - sum / count) * (value - sum / count);
  }
  return {sum / count, std::sqrt(squares / count)};
}

inline double correlationOf(const std::vector<double>& a, const std::vector<double>& b) {
  const Moments of_a = momentsOf(a), of_b = momentsOf(b);
  double product = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    product += (a[i] - of_a.mean) * (b[i] - of_b.mean);
  }
  return product / static_cast<double>(a.size()) / of_a.deviation / of_b.deviation;
}

}  // namespace sfw::test
