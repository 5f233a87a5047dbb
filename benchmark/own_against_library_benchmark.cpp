// Compares three hand-written parts of the mapper with library code in the same run. Sums over rays
// compete with Eigen's sparse products, and rows of Vecchia's factor with Eigen's Cholesky
// factorisation. Nearest positions compete with the R-tree of Boost.
//
// Usage: own_against_library_benchmark
// It runs on the bins of drives through a generated office floor of 400 m2. Both parts of a pair
// run in turns. Times are CPU times, so other processes on the machine hardly change the ratios.

#include <Eigen/Cholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <iterator>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "comparison.h"
#include "office_floor.h"
#include "radio/nearest_neighbours.h"
#include "radio/vecchia_rows.h"
#include "simulation/robot/route.h"
#include "simulation/robot/route_planner.h"
#include "tomography/line_rays.h"
#include "tomography/sparse_sums.h"

namespace sfw {
namespace {

constexpr double kBin = 0.2;   // [m]
constexpr double kLine = 0.2;  // [m], edge of a cell of the lattice of walls
constexpr int kNeighbours = 12;

struct Drive {
  GridGeometry lattice;
  Position access_point;
  std::vector<Position> positions;
};

/// Positions every 0.2 m on laps along the walls. Each lap is 7 cm beside the previous one.
Drive officeDrive(std::size_t count) {
  const FloorPlan plan = officeFloor();
  const Route route(planRoute(toStates(plan), RouteKind::kWalls), 1.0, 1000.0);
  std::vector<Position> positions;
  for (std::size_t i = 0; i < count; ++i) {
    const double driven_s = kBin * static_cast<double>(i);  // at 1 m/s
    const double lap = std::floor(driven_s / route.duration());
    positions.emplace_back(route.poseAt(driven_s - lap * route.duration()).position +
                           lap * Position(0.0, 0.07));
  }
  const Box box = plan.geometry.box();
  return {GridGeometry::covering(box, kLine, kLine, 1000000),
          positions.front() + Position(0.1, 0.1), positions};
}

/// The pieces of wall that each ray crosses, as Rays has them.
struct Crossings {
  SparseSums::Choice choice;
  std::size_t unknowns;
};

Crossings crossings(const Drive& drive) {
  const LineLattice lattice{drive.lattice};
  Unknowns unknowns({lattice});
  SparseSums::Choice choice;
  for (std::size_t ray = 0; ray < drive.positions.size(); ++ray) {
    forEachLine(lattice.geometry, drive.access_point, drive.positions[ray],
                [&](bool walls_along_y, Cell cell) {
                  const std::int32_t slot = unknowns.slot({0, walls_along_y}, cell);
                  unknowns.add(slot);
                  choice.sum.push_back(static_cast<std::int32_t>(ray));
                  choice.term.push_back(slot);
                });
  }
  unknowns.number();
  for (std::int32_t& slot : choice.term) {
    slot = unknowns.in(slot);
  }
  return {std::move(choice), unknowns.size()};
}

/// The sums over rays by both, and the vectors that they fill.
struct Sums {
  using Matrix = Eigen::SparseMatrix<float, Eigen::RowMajor>;

  explicit Sums(const Crossings& crossed, std::size_t rays)
      : along(rays, crossed.unknowns, crossed.choice),
        spread(crossed.unknowns, rays, SparseSums::transposed(crossed.choice)),
        matrix(static_cast<Eigen::Index>(rays), static_cast<Eigen::Index>(crossed.unknowns)),
        loss(Eigen::VectorXf::Ones(matrix.cols())) {
    std::vector<Eigen::Triplet<float>> ones;
    for (std::size_t i = 0; i < crossed.choice.sum.size(); ++i) {
      ones.emplace_back(crossed.choice.sum[i], crossed.choice.term[i], 1.0F);
    }
    matrix.setFromTriplets(ones.begin(), ones.end());
    transposed = matrix.transpose();
  }

  SparseSums along, spread;
  Matrix matrix, transposed;
  Eigen::VectorXf loss, sums, gradient;
};

/// The work of some iterations: sums over the rays, and sums over the pieces of wall.
Pair sumsOverRays(const Drive& drive) {
  constexpr int kIterations = 120;
  const std::size_t rays = drive.positions.size();
  const auto both = std::make_shared<Sums>(crossings(drive), rays);
  return {rays,
          [=] {
            for (int i = 0; i < kIterations; ++i) {
              both->along.of(both->loss, both->sums);
              both->spread.of(both->sums, both->gradient);
            }
            return static_cast<double>(both->gradient.sum());
          },
          [=] {
            for (int i = 0; i < kIterations; ++i) {
              both->sums.noalias() = both->matrix * both->loss;
              both->gradient.noalias() = both->transposed * both->sums;
            }
            return static_cast<double>(both->gradient.sum());
          }};
}

std::vector<int> shuffled(std::size_t count) {
  std::vector<int> order(count);
  for (std::size_t i = 0; i < count; ++i) {
    order[i] = static_cast<int>(i);
  }
  std::shuffle(order.begin(), order.end(), std::mt19937(1));
  return order;
}

/// Each position with its nearest ones among those before it.
std::vector<std::vector<int>> rowsOf(const std::vector<Position>& positions) {
  NearestNeighbours before(positions);
  std::vector<std::vector<int>> rows;
  for (const int number : shuffled(positions.size())) {
    std::vector<int> row{number};
    for (const auto& [square, other] :
         before.nearest(positions[static_cast<std::size_t>(number)], kNeighbours)) {
      row.push_back(other);
    }
    if (row.size() == kNeighbours + 1) {
      rows.push_back(row);
    }
    before.enter(number);
  }
  return rows;
}

double weightsInLanes(const std::vector<Position>& positions,
                      const std::vector<std::vector<int>>& rows, const SignalCovariance& model,
                      double own_db2) {
  double sum = 0.0;
  VecchiaRows<kNeighbours> batch;
  for (std::size_t first = 0; first + kLanes <= rows.size(); first += kLanes) {
    for (int lane = 0; lane < kLanes; ++lane) {
      const std::vector<int>& row = rows[first + static_cast<std::size_t>(lane)];
      for (int i = 0; i <= kNeighbours; ++i) {
        const int number = row[static_cast<std::size_t>(i)];
        batch.put(lane, i, positions[static_cast<std::size_t>(number)], own_db2);
      }
    }
    batch.solve(model);
    for (int lane = 0; lane < kLanes; ++lane) {
      sum += batch.scale(lane) + batch.weight(lane, 0);
    }
  }
  return sum;
}

double weightsByEigen(const std::vector<Position>& positions,
                      const std::vector<std::vector<int>>& rows, const SignalCovariance& model,
                      double own_db2) {
  using Square = Eigen::Matrix<double, kNeighbours, kNeighbours>;
  using Column = Eigen::Array<double, kNeighbours, 1>;
  const double variance_db2 = model.shadowing_db * model.shadowing_db;
  const double rate = -1.0 / model.shadowing_distance_m;
  double sum = 0.0;
  for (const std::vector<int>& row : rows) {
    Column x, y;
    for (int i = 0; i < kNeighbours; ++i) {
      const Position& position =
          positions[static_cast<std::size_t>(row[static_cast<std::size_t>(i) + 1])];
      x[i] = position.x();
      y[i] = position.y();
    }
    const auto shared = [&](double to_x, double to_y) -> Column {
      return variance_db2 * (rate * ((x - to_x).square() + (y - to_y).square()).sqrt()).exp();
    };
    Square among;
    for (int i = 0; i < kNeighbours; ++i) {
      among.col(i) = shared(x[i], y[i]);
    }
    among.diagonal().array() += own_db2;
    const Position& position = positions[static_cast<std::size_t>(row[0])];
    const Eigen::Matrix<double, kNeighbours, 1> with = shared(position.x(), position.y()).matrix();
    const Eigen::Matrix<double, kNeighbours, 1> weight = Eigen::LLT<Square>(among).solve(with);
    const double left = variance_db2 + own_db2 - with.dot(weight);
    sum += 1.0 / std::sqrt(std::max(left, own_db2)) + weight[0];
  }
  return sum;
}

Pair rowsOfFactor(const Drive& drive) {
  const auto rows = std::make_shared<const std::vector<std::vector<int>>>(rowsOf(drive.positions));
  const SignalCovariance model;
  const double own_db2 = 9.0 + model.nugget_db2;
  const std::vector<Position>& at = drive.positions;
  return {rows->size(), [=] { return weightsInLanes(at, *rows, model, own_db2); },
          [=] { return weightsByEigen(at, *rows, model, own_db2); }};
}

double nearestByCells(const std::vector<Position>& positions, const std::vector<int>& order) {
  double sum = 0.0;
  NearestNeighbours before(positions);
  for (const int number : order) {
    for (const auto& [square, other] :
         before.nearest(positions[static_cast<std::size_t>(number)], kNeighbours)) {
      sum += square + other;
    }
    before.enter(number);
  }
  return sum;
}

/// Nearest positions at equal distance come in any order, because sorting would cost more.
double nearestByTree(const std::vector<Position>& positions, const std::vector<int>& order) {
  namespace index = boost::geometry::index;
  using Point = boost::geometry::model::d2::point_xy<double>;
  using Value = std::pair<Point, int>;
  double sum = 0.0;
  index::rtree<Value, index::quadratic<16>> before;
  std::vector<Value> found;
  for (const int number : order) {
    const Position& position = positions[static_cast<std::size_t>(number)];
    const Point to(position.x(), position.y());
    found.clear();
    before.query(index::nearest(to, kNeighbours), std::back_inserter(found));
    for (const auto& [point, other] : found) {
      sum += boost::geometry::comparable_distance(point, to) + other;
    }
    before.insert({to, number});
  }
  return sum;
}

Pair nearestSoFar(const Drive& drive) {
  const std::vector<int> order = shuffled(drive.positions.size());
  const std::vector<Position>& at = drive.positions;
  return {order.size(), [=] { return nearestByCells(at, order); },
          [=] { return nearestByTree(at, order); }};
}

void declare(std::size_t positions) {
  const auto add = [&](const std::string& part, Pair (*pair)(const Drive&)) {
    declareComparison(part + '/' + std::to_string(positions),
                      [=] { return pair(officeDrive(positions)); });
  };
  add("sums over rays, 120 iterations/Eigen's sparse product", sumsOverRays);
  add("rows of Vecchia's factor/Eigen's LLT", rowsOfFactor);
  add("12 nearest among positions so far/R-tree", nearestSoFar);
}

}  // namespace
}  // namespace sfw

int main(int count, char** arguments) {
  return sfw::runBenchmarks(count, arguments, [](const auto& /*none*/) {
    for (const std::size_t positions : {500, 2000, 4500}) {
      sfw::declare(positions);
    }
  });
}
