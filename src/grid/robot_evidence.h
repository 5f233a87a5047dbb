#pragma once

#include <vector>

#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/types.h"

namespace sfw {

// The evidence of the robot's body: covered cells are free, and touched cells are not.

constexpr float kUnknownOccupancy = 0.5F;     ///< of a cell without any evidence
constexpr float kFootprintOccupancy = 0.02F;  ///< of a cell that the robot's footprint covered
constexpr float kContactOccupancy = 0.95F;    ///< of a cell in which the robot touched something

/// Sets the cells of contacts to kContactOccupancy; contacts outside the grid are ignored.
inline void stampContacts(const std::vector<Contact>& contacts, Grid<float>& occupied) {
  for (const Contact& contact : contacts) {
    const Cell c = occupied.geometry.cellAt(contact.point_in_map);
    if (occupied.geometry.contains(c)) {
      occupied[c] = kContactOccupancy;
    }
  }
}

}  // namespace sfw
