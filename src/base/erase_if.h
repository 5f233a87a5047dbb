#pragma once

#include <utility>
#include <vector>

namespace sfw {

/// Erases the elements that fulfil a predicate. Calls the predicate once for each element, in
/// order.
template <class T, class Predicate>
void eraseIf(std::vector<T>& all, Predicate&& predicate) {
  auto kept = all.begin();
  for (auto one = all.begin(); one != all.end(); ++one) {
    if (predicate(*one)) {
      continue;
    }
    if (kept != one) {  // a move to itself may empty an element
      *kept = std::move(*one);
    }
    ++kept;
  }
  all.erase(kept, all.end());
}

}  // namespace sfw
