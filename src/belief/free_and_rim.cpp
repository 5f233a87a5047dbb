#include "belief/free_and_rim.h"

#include <algorithm>
#include <cstdint>

#include "grid/distance_transform.h"
#include "grid/morphology.h"
#include "grid/robot_evidence.h"

namespace sfw {
namespace {

/// Rounding of the stored map must not carry a probability across a threshold: this margin keeps
/// probabilities away from both [1].
constexpr float kMargin = 0.02F;

/// Margin below the threshold of free cells [1]: nearly twice the largest step of the stored log
/// odds there.
constexpr float kFreeMargin = 0.015F;

/// An island in a free area becomes free if every cell's probability is below this many times the
/// threshold. Such cells are hardly more doubtful than the free cells around.
constexpr float kIslandDoubt = 1.4F;

/// Keeps only the parts of a set that are connected with the seeds over edges.
Mask reachable(const Mask& free, const Mask& seeds) {
  const Components parts = labelComponents(free);
  std::vector<std::uint8_t> reached(static_cast<std::size_t>(parts.count) + 1, 0);
  for (std::size_t i = 0; i < seeds.cells.size(); ++i) {
    if (seeds.cells[i] != 0) {
      reached[static_cast<std::size_t>(parts.label.cells[i])] = 1;
    }
  }
  reached[0] = 0;
  Mask result(free.geometry);
  for (std::size_t i = 0; i < result.cells.size(); ++i) {
    result.cells[i] = reached[static_cast<std::size_t>(parts.label.cells[i])];
  }
  return result;
}

/// Adds to a free area each island in it whose cells are all less likely than `likely` to be
/// occupied.
void freeIslands(const Grid<float>& occupied, float likely, Mask& free) {
  const GridGeometry& geometry = free.geometry;
  const Components islands = labelComponents(complement(free));
  std::vector<std::uint8_t> freed(static_cast<std::size_t>(islands.count) + 1, 1);
  for (std::size_t i = 0; i < free.cells.size(); ++i) {
    const Cell c = geometry.cell(i);
    const bool at_edge =
        c.x == 0 || c.y == 0 || c.x + 1 == geometry.width() || c.y + 1 == geometry.height();
    if (at_edge || occupied.cells[i] >= likely) {
      freed[static_cast<std::size_t>(islands.label.cells[i])] = 0;
    }
  }
  freed[0] = 1;  // free already
  for (std::size_t i = 0; i < free.cells.size(); ++i) {
    free.cells[i] = freed[static_cast<std::size_t>(islands.label.cells[i])];
  }
}

}  // namespace

void stampFootprintAndContacts(const Mask& path, const std::vector<Contact>& contacts,
                               double footprint_radius_m, Grid<float>& occupied) {
  const Grid<double> distance = distanceTransform(path);
  const double radius_cells = footprint_radius_m / occupied.geometry.resolution();
  for (std::size_t i = 0; i < occupied.cells.size(); ++i) {
    if (distance.cells[i] <= radius_cells) {
      occupied.cells[i] = std::min(occupied.cells[i], kFootprintOccupancy);
    }
  }
  stampContacts(contacts, occupied);
}

void labelFreeAndRim(const Mask& path, const Mask& walls, const Config::Belief& config,
                     Grid<float>& occupied) {
  const auto free_below = static_cast<float>(config.free_threshold);
  const auto occupied_above = static_cast<float>(config.occupied_threshold);
  const float least_occupied = std::min(occupied_above + kMargin, 1.0F);
  for (std::size_t i = 0; i < walls.cells.size(); ++i) {
    if (walls.cells[i] != 0) {
      occupied.cells[i] = std::max(occupied.cells[i], least_occupied);
    }
  }
  Mask free(occupied.geometry);
  for (std::size_t i = 0; i < free.cells.size(); ++i) {
    free.cells[i] = occupied.cells[i] < free_below ? 1 : 0;
  }
  free = reachable(free, path);
  freeIslands(occupied, std::min(kIslandDoubt * free_below, kUnknownOccupancy), free);
  constexpr double kNeighbour = 1.5;  // cells: over edges and corners
  const bool rim_is_occupied = config.rim == "occupied";
  const Mask rim = rim_is_occupied ? dilated(free, kNeighbour) : Mask(free.geometry);
  const float least = std::min(free_below + kMargin, 0.5F * (free_below + occupied_above));
  const float most = std::max(occupied_above - kMargin, least);
  for (std::size_t i = 0; i < free.cells.size(); ++i) {
    float& p = occupied.cells[i];
    if (free.cells[i] != 0) {
      p = std::min(p, free_below - std::min(kFreeMargin, 0.5F * free_below));
      continue;
    }
    if (p == kContactOccupancy || p == kUnknownOccupancy) {
      continue;
    }
    const bool is_occupied = rim.cells[i] != 0 || walls.cells[i] != 0;
    p = is_occupied ? std::max(p, least_occupied) : std::clamp(p, least, most);
  }
}

}  // namespace sfw
