#include "simulation/building/wall_crossings.h"

#include <optional>

#include "grid/ray.h"

namespace sfw {
namespace {

bool isWall(CellState state) { return state == CellState::kOccupied; }
bool isWall(Material material) {
  return material == Material::kInteriorWall || material == Material::kOuterWall;
}

/// The contact of a ray with a wall: in one cell, or at the common corner of two cells.
struct Contact {
  Cell a;
  Cell b;
};

/// Calls `visit(Contact, goes_on)` for each contact of a ray with wall cells, in order. `goes_on`
/// is true if nothing lies between this contact and the previous one.
template <class T, class Visitor>
void forEachContact(const Grid<T>& plan, const Position& from, const Position& to,
                    Visitor&& visit) {
  const auto is_wall = [&plan](Cell c) { return plan.geometry.contains(c) && isWall(plan[c]); };
  std::optional<Cell> last;
  bool in_wall = false;
  Ray(plan.geometry, from, to).forEachCell([&](Cell c) {
    if (last && last->x != c.x && last->y != c.y) {
      const Contact corner{{last->x, c.y}, {c.x, last->y}};
      if (is_wall(corner.a) && is_wall(corner.b)) {
        visit(corner, in_wall);
        in_wall = true;
      }
    }
    if (is_wall(c)) {
      visit(Contact{c, c}, in_wall);
    }
    in_wall = is_wall(c);
    last = c;
  });
}

/// One wall's first and last contact.
struct Run {
  Contact first;
  Contact last;
  int contacts = 1;
  int outer = 0;  // contacts with outer walls
};

bool isOuter(CellState) { return false; }
bool isOuter(Material material) { return material == Material::kOuterWall; }

template <class T>
std::vector<Run> runsBetween(const Grid<T>& plan, const Position& from, const Position& to) {
  std::vector<Run> runs;
  forEachContact(plan, from, to, [&](const Contact& contact, bool goes_on) {
    if (goes_on) {
      runs.back().last = contact;
      ++runs.back().contacts;
    } else {
      runs.push_back({contact, contact});
    }
    runs.back().outer += isOuter(plan[contact.a]) ? 1 : 0;
  });
  // A wall that contains an end does not count.
  if (!runs.empty() && runs.back().last.a == plan.geometry.cellAt(to)) {
    runs.pop_back();
  }
  if (!runs.empty() && runs.front().first.a == plan.geometry.cellAt(from)) {
    runs.erase(runs.begin());
  }
  return runs;
}

Position middleOf(const GridGeometry& geometry, const Contact& contact) {
  return 0.5 * (geometry.centre(contact.a) + geometry.centre(contact.b));
}

}  // namespace

std::vector<WallCrossing> wallsBetween(const FloorPlan& plan, const Position& from,
                                       const Position& to) {
  std::vector<WallCrossing> walls;
  for (const Run& run : runsBetween(plan, from, to)) {
    const Position middle =
        0.5 * (middleOf(plan.geometry, run.first) + middleOf(plan.geometry, run.last));
    walls.push_back(
        {middle, 2 * run.outer > run.contacts ? Material::kOuterWall : Material::kInteriorWall});
  }
  return walls;
}

int countWalls(const FloorPlan& plan, const Position& from, const Position& to) {
  return static_cast<int>(runsBetween(plan, from, to).size());
}

int countWalls(const Grid<CellState>& plan, const Position& from, const Position& to) {
  return static_cast<int>(runsBetween(plan, from, to).size());
}

}  // namespace sfw
