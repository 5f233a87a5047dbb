#include "training/survey_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "grid/for_each_cell.h"
#include "training/clearance.h"

namespace sfw {
namespace {

constexpr std::size_t kNoPlace = std::numeric_limits<std::size_t>::max();
constexpr double kLongestWay = 1.99;    // [m], just below the gap at which a survey's path breaks
constexpr double kWayClearance = 0.04;  // [m], a person carries the receiver through narrow doors

/// Steps on the lattice: to the side, across, and over one place left out.
constexpr std::array<std::array<std::int64_t, 2>, 12> kSteps{{{1, 0},
                                                              {0, 1},
                                                              {-1, 0},
                                                              {0, -1},
                                                              {1, 1},
                                                              {1, -1},
                                                              {-1, 1},
                                                              {-1, -1},
                                                              {2, 0},
                                                              {-2, 0},
                                                              {0, 2},
                                                              {0, -2}}};

/// A lattice over a building. A cell of a grid stands for each place.
struct Lattice {
  Position first;            // [m]
  Position spacing;          // [m]
  Grid<std::size_t> number;  // of each place, or kNoPlace

  Position at(Cell c) const {
    return first +
           spacing.cwiseProduct(Position(static_cast<double>(c.x), static_cast<double>(c.y)));
  }
};

Lattice randomLattice(const Box& box, Random& random) {
  const double along_x = random.uniform(0.5, 1.7);
  const double along_y = random.uniform() < 0.6 ? along_x : random.uniform(0.5, 1.7);
  const Position spacing(along_x, along_y);
  const Position offset = spacing.cwiseProduct(Position(random.uniform(), random.uniform()));
  const Position count = box.sizes().cwiseQuotient(spacing).array().floor() + 1.0;
  const GridGeometry geometry(1.0, Position::Zero(), static_cast<std::int64_t>(count.x()),
                              static_cast<std::int64_t>(count.y()));
  return {box.min() + offset, spacing, Grid<std::size_t>(geometry, kNoPlace)};
}

}  // namespace

SurveyPlaces::SurveyPlaces(const FloorPlan& plan, Random& random) {
  constexpr double kLeftOut = 0.05;  // share of the places
  Lattice lattice = randomLattice(plan.geometry.box(), random);
  const double least_m = random.uniform(0.05, 0.3);
  const Clearance clearance(plan, kWayClearance);
  std::vector<Cell> cells;
  forEachCell(lattice.number.geometry, [&](Cell c) {
    const bool left_out = random.uniform() < kLeftOut;
    if (!left_out && clearance.at(plan.geometry.cellAt(lattice.at(c))) >= least_m) {
      lattice.number[c] = positions_.size();
      positions_.push_back(lattice.at(c));
      cells.push_back(c);
    }
  });
  neighbours_.resize(positions_.size());
  for (std::size_t place = 0; place < cells.size(); ++place) {
    for (const auto& step : kSteps) {
      const Cell c{cells[place].x + step[0], cells[place].y + step[1]};
      const std::size_t next = lattice.number.geometry.contains(c) ? lattice.number[c] : kNoPlace;
      if (next != kNoPlace && (positions_[next] - positions_[place]).norm() < kLongestWay &&
          clearance.allows(positions_[place], positions_[next])) {
        neighbours_[place].push_back(next);
      }
    }
  }
}

std::vector<std::size_t> SurveyPlaces::reachableFrom(std::size_t start) const {
  std::vector<bool> reached(positions_.size());
  std::vector<std::size_t> queue{start};
  reached[start] = true;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (const std::size_t next : neighbours_[queue[i]]) {
      if (!reached[next]) {
        reached[next] = true;
        queue.push_back(next);
      }
    }
  }
  return queue;
}

std::vector<std::size_t> SurveyPlaces::largestConnectedSet() const {
  std::vector<std::size_t> largest;
  std::vector<bool> done(positions_.size());
  for (std::size_t place = 0; place < positions_.size(); ++place) {
    if (done[place]) {
      continue;
    }
    const std::vector<std::size_t> connected = reachableFrom(place);
    for (const std::size_t one : connected) {
      done[one] = true;
    }
    if (connected.size() > largest.size()) {
      largest = connected;
    }
  }
  return largest;
}

/// The places on the shortest way to a place without a visit, by breadth first. Among equally near
/// ones, the place that lies most ahead is preferred. Empty if there is none.
std::vector<std::size_t> SurveyPlaces::wayToNearest(std::size_t start, const Position& heading,
                                                    const std::vector<bool>& visited) const {
  const auto ahead = [&](std::size_t place) {
    return heading.dot((positions_[place] - positions_[start]).normalized());
  };
  std::vector<std::size_t> from(positions_.size(), kNoPlace);
  std::vector<std::size_t> queue{start};
  from[start] = start;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    std::vector<std::size_t> nexts = neighbours_[queue[i]];
    if (i == 0) {
      std::stable_sort(nexts.begin(), nexts.end(),
                       [&](std::size_t a, std::size_t b) { return ahead(a) > ahead(b); });
    }
    for (const std::size_t next : nexts) {
      if (from[next] != kNoPlace) {
        continue;
      }
      from[next] = queue[i];
      queue.push_back(next);
      if (!visited[next]) {
        std::vector<std::size_t> way;
        for (std::size_t place = next; place != start; place = from[place]) {
          way.push_back(place);
        }
        return {way.rbegin(), way.rend()};
      }
    }
  }
  return {};
}

std::vector<std::size_t> SurveyPlaces::walk(Random& random) const {
  const std::vector<std::size_t> places = largestConnectedSet();
  if (places.empty()) {
    return {};
  }
  const auto count = static_cast<double>(places.size());
  const double share = random.uniform() < 0.6 ? 1.0 : random.uniform(0.3, 0.9);
  const bool keeps_heading = random.uniform() < 0.5;
  std::vector<std::size_t> walk{places[static_cast<std::size_t>((1.0 - random.uniform()) * count)]};
  std::vector<bool> visited(positions_.size());
  visited[walk.back()] = true;
  Position heading = Position::Zero();
  for (double done = 1.0; done < share * count; ++done) {
    if (!keeps_heading) {
      heading = Position(random.normal(), random.normal());
    }
    const std::vector<std::size_t> way = wayToNearest(walk.back(), heading, visited);
    if (way.empty()) {
      break;
    }
    walk.insert(walk.end(), way.begin(), way.end());
    visited[walk.back()] = true;
    heading = (position(walk.back()) - position(walk[walk.size() - 2])).normalized();
  }
  return walk;
}

}  // namespace sfw
