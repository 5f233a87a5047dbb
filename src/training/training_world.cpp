#include "training/training_world.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/random_streams.h"
#include "grid/for_each_cell.h"
#include "simulation/building/floor_plan_generator.h"
#include "training/clearance.h"

namespace sfw {
namespace {

constexpr double kTurn = 2.0 * kPi;

Position randomStep(double length_m, Random& random) {
  const double bearing = random.uniform(0.0, kTurn);
  return length_m * Position(std::cos(bearing), std::sin(bearing));
}

/// Adds way points to a route so that no two are much more than 1.2 m apart.
std::vector<Position> divided(const std::vector<Position>& route) {
  constexpr double kLongest = 1.2;  // [m]
  std::vector<Position> dense;
  for (std::size_t i = 0; i + 1 < route.size(); ++i) {
    const Position step = route[i + 1] - route[i];
    const int parts = std::max(1, static_cast<int>(step.norm() / kLongest));
    for (int part = 0; part < parts; ++part) {
      dense.emplace_back(route[i] + step * (static_cast<double>(part) / parts));
    }
  }
  dense.push_back(route.back());
  return dense;
}

/// Chaikin's corner cutting (1974), where there is enough space.
std::vector<Position> smoothed(const std::vector<Position>& route, const Clearance& clearance) {
  std::vector<Position> smooth{route.front()};
  for (std::size_t i = 1; i + 1 < route.size(); ++i) {
    const Position before = 0.75 * route[i] + 0.25 * route[i - 1];
    const Position after = 0.75 * route[i] + 0.25 * route[i + 1];
    if (clearance.allows(before, after)) {
      smooth.insert(smooth.end(), {before, after});
    } else {
      smooth.push_back(route[i]);
    }
  }
  smooth.push_back(route.back());
  return smooth;
}

}  // namespace

FloorPlan makeTrainingBuilding(std::int64_t seed) {
  constexpr std::uint64_t kStream = 0x666974;  // no simulation uses it
  Random random(seed, kStream, 0);
  BuildingConfig config;
  config.seed = static_cast<std::uint64_t>(seed);
  config.kind = random.uniform() < 0.25 ? BuildingKind::kOffice : BuildingKind::kFlat;
  config.area_m2 = random.uniform(35.0, 135.0);
  config.rotation_rad = random.uniform() < 0.5 ? 0.0 : random.uniform(0.0, 1.57);
  return generateFloorPlan(config);
}

FloorPlan makeSurveyBuilding(std::int64_t seed) {
  Random random(seed, streamOf(Purpose::kSurvey), 0);
  BuildingConfig config;
  config.seed = static_cast<std::uint64_t>(seed);
  config.kind = random.uniform() < 0.8 ? BuildingKind::kOffice : BuildingKind::kFlat;
  config.area_m2 = random.uniform(60.0, 260.0);
  return generateFloorPlan(config);
}

void cutOut(FloorPlan& plan, Random& random) {
  constexpr double kWall = 0.2;  // [m]
  const GridGeometry geometry = plan.geometry;
  Box building;
  forEachCell(geometry, [&](Cell c) {
    if (plan[c] == Material::kFree) {
      building.extend(geometry.centre(c));
    }
  });
  const Position extent = building.sizes();
  const int count = 1 + static_cast<int>(random.uniform(0.0, 2.99));
  for (int i = 0; i < count; ++i) {
    const Position size(1.0 + random.uniform() * std::min(4.0, 0.45 * extent.x()),
                        1.0 + random.uniform() * std::min(4.0, 0.45 * extent.y()));
    const Position corner = building.min() +
                            extent.cwiseProduct(Position(random.uniform(), random.uniform())) -
                            0.5 * size;
    forEachCell(geometry, [&](Cell c) {
      const Position inside = geometry.centre(c) - corner;
      const double depth = std::min(inside.minCoeff(), (size - inside).minCoeff());
      if (depth >= 0.0 && plan[c] != Material::kUnknown) {
        plan[c] = depth < kWall ? Material::kOuterWall : Material::kUnknown;
      }
    });
  }
}

void furnish(FloorPlan& plan, Random& random) {
  const GridGeometry geometry = plan.geometry;
  const Clearance clearance(plan, 0.0);
  std::vector<Cell> against_walls;
  double area = 0.0;
  forEachCell(geometry, [&](Cell c) {
    if (plan[c] == Material::kFree) {
      area += geometry.resolution() * geometry.resolution();
      if (clearance.at(c) <= 1.5 * geometry.resolution()) {
        against_walls.push_back(c);
      }
    }
  });
  const int pieces = static_cast<int>(area / random.uniform(3.0, 9.0));
  for (int i = 0; i < pieces && !against_walls.empty(); ++i) {
    const auto chosen = static_cast<std::size_t>((1.0 - random.uniform()) *
                                                 static_cast<double>(against_walls.size()));
    const Position at = geometry.centre(against_walls[chosen]);
    Position half(random.uniform(0.2, 1.0), random.uniform(0.15, 0.6));
    const double depth = half.y();
    if (random.uniform() < 0.5) {
      std::swap(half.x(), half.y());
    }
    forEachCell(geometry, [&](Cell c) {
      const Position off = (geometry.centre(c) - at).cwiseAbs();
      if (plan[c] == Material::kFree && clearance.at(c) < depth + 0.1 && off.x() < half.x() &&
          off.y() < half.y()) {
        plan[c] = Material::kInteriorWall;
      }
    });
  }
}

std::vector<Position> withHumanSteering(const std::vector<Position>& route, const FloorPlan& plan,
                                        double clearance_m, Random& random) {
  const Clearance clearance(plan, clearance_m);
  const double displacement = random.uniform(0.1, 0.5);
  const double left_out = random.uniform(0.0, 0.35);
  const std::vector<Position> dense = divided(route);
  std::vector<Position> loose{dense.front()};
  for (std::size_t i = 1; i < dense.size(); ++i) {
    const Position& next = dense[std::min(i + 1, dense.size() - 1)];
    if (i + 1 < dense.size() && random.uniform() < left_out &&
        clearance.allows(loose.back(), next)) {
      continue;
    }
    Position position = dense[i];
    for (int attempt = 0; attempt < 4; ++attempt) {
      const Position candidate = dense[i] + randomStep(displacement * random.uniform(), random);
      if (clearance.allows(loose.back(), candidate) && clearance.allows(candidate, next)) {
        position = candidate;
        break;
      }
    }
    loose.push_back(position);
  }
  return smoothed(smoothed(loose, clearance), clearance);
}

std::vector<Position> withRandomWalks(const std::vector<Position>& route, const FloorPlan& plan,
                                      double clearance_m, Random& random) {
  constexpr double kFarthest = 3.0;  // [m] from the way point
  const Clearance clearance(plan, clearance_m);
  const double longest = random.uniform(0.2, 1.2);
  const double most = random.uniform(6.0, 46.0);
  std::vector<Position> stroll;
  for (const Position& start : route) {
    stroll.push_back(start);
    if (random.uniform() < 0.25) {
      continue;
    }
    std::vector<Position> out{start};
    const int steps = static_cast<int>(random.uniform(0.0, most));
    for (int i = 0; i < steps; ++i) {
      const Position next = out.back() + randomStep(longest * std::sqrt(random.uniform()), random);
      if ((next - start).norm() < kFarthest && clearance.allows(out.back(), next)) {
        out.push_back(next);
        stroll.push_back(next);
      }
    }
    // The robot returns on its own path until the way point is in sight.
    while (out.size() > 1) {
      out.pop_back();
      stroll.push_back(out.back());
      if (clearance.allows(out.back(), start)) {
        break;
      }
    }
    stroll.push_back(start);
  }
  return stroll;
}

}  // namespace sfw
