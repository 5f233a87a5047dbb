#include "simulation/building/floor_plan_generator.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/validation.h"
#include "grid/for_each_cell.h"
#include "simulation/building/floor_layout.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// A layout in its final position in the building's frame [cm].
struct Building {
  int outer_wall;
  std::vector<Rect> inside;
  std::vector<Rect> free;  // rooms and holes
};

/// One of the eight ways in which a rectilinear layout can be turned and mirrored.
class Turn {
 public:
  explicit Turn(PortableRandom& random)
      : transpose_(random.chance(50)), mirror_x_(random.chance(50)), mirror_y_(random.chance(50)) {}

  Rect operator()(const Rect& rect) const {
    const Rect t = transpose_ ? rect.transposed() : rect;
    return {mirror_x_ ? -t.right : t.left, mirror_y_ ? -t.top : t.bottom,
            mirror_x_ ? -t.left : t.right, mirror_y_ ? -t.bottom : t.top};
  }

 private:
  bool transpose_, mirror_x_, mirror_y_;
};

Building build(const BuildingConfig& config) {
  PortableRandom random(config.seed);
  FloorLayout layout(random, random.between(10, 13));
  const int area_m2 = static_cast<int>(std::lround(config.area_m2));
  if (config.kind == BuildingKind::kFlat) {
    drawFlat(area_m2, layout);
  } else {
    drawOffice(area_m2, layout);
  }
  layout.reachAll();
  const Turn turn(random);
  Building building{random.between(25, 35), {}, {}};
  for (const Rect& rect : layout.inside()) {
    building.inside.push_back(turn(rect));
  }
  for (const LayoutRoom& room : layout.rooms()) {
    building.free.push_back(turn(room.rect));
  }
  for (const Rect& hole : layout.holes()) {
    building.free.push_back(turn(hole));
  }
  return building;
}

/// Whether a point [cm] lies in one of the rectangles, each grown by `wall`.
bool within(const std::vector<Rect>& rects, const Position& at, int wall) {
  return std::any_of(rects.begin(), rects.end(), [&](const Rect& rect) {
    return at.x() >= rect.left - wall && at.x() < rect.right + wall &&
           at.y() >= rect.bottom - wall && at.y() < rect.top + wall;
  });
}

Material materialAt(const Building& building, const Position& at) {
  if (within(building.free, at, 0)) {
    return Material::kFree;
  }
  if (within(building.inside, at, 0)) {
    return Material::kInteriorWall;
  }
  return within(building.inside, at, building.outer_wall) ? Material::kOuterWall
                                                          : Material::kUnknown;
}

/// The rectangle around the rotated building [m], with a margin.
Box boxAround(const Building& building, const Eigen::Rotation2Dd& map_from_building) {
  constexpr double kMargin = 0.5;
  Box box;
  for (const Rect& rect : building.inside) {
    for (const int x : {rect.left - building.outer_wall, rect.right + building.outer_wall}) {
      for (const int y : {rect.bottom - building.outer_wall, rect.top + building.outer_wall}) {
        box.extend(map_from_building * (Position(x, y) / 100.0));
      }
    }
  }
  return {box.min().array() - kMargin, box.max().array() + kMargin};
}

FloorPlan rasterised(const Building& building, const BuildingConfig& config,
                     const Eigen::Rotation2Dd& map_from_building) {
  // Centres of cells may lie on edges of walls. Rounding must not decide their side.
  const Position nudge(1e-6, 1e-6);
  constexpr std::int64_t kMostCells = 64'000'000;
  FloorPlan plan(GridGeometry::covering(boxAround(building, map_from_building), config.resolution_m,
                                        config.resolution_m, kMostCells));
  const Eigen::Rotation2Dd building_from_map = map_from_building.inverse();
  forEachCell(plan.geometry, [&](Cell c) {
    const Position at = building_from_map * plan.geometry.centre(c) + nudge;
    plan[c] = materialAt(building, 100.0 * at);
  });
  return plan;
}

}  // namespace

BuildingKind parseBuildingKind(std::string_view name) {
  if (name != "flat" && name != "office") {
    throw InputError("'" + std::string(name) +
                     "' is no kind of building; the kinds are flat, office");
  }
  return name == "flat" ? BuildingKind::kFlat : BuildingKind::kOffice;
}

std::vector<std::string> validate(const BuildingConfig& config) {
  Problems problems;
  problems.within("area", config.area_m2, 30.0, 400.0, "m2");
  problems.within("resolution", config.resolution_m, 0.01, 0.1, "m");
  problems.require(std::isfinite(config.rotation_rad), "rotation_rad", config.rotation_rad,
                   "finite");
  return problems.list();
}

FloorPlan generateFloorPlan(const BuildingConfig& config) {
  throwIfAny(validate(config));
  return rasterised(build(config), config, Eigen::Rotation2Dd(config.rotation_rad));
}

}  // namespace sfw
