#pragma once

#include "structure_from_wifi/data_checks.h"
#include "structure_from_wifi/snapshot.h"

namespace sfw {

/// Moves everything in a map that has a place. The offset of the result is `by` more.
///
/// A map is made near its frame's origin, since MRPT counts in single precision. Its files may lie
/// anywhere.
Snapshot moved(Snapshot snapshot, const Position& by);

/// Moves the findings on a map with it.
DataFindings moved(DataFindings findings, const Position& by);

/// Moves a grid.
template <class T>
Grid<T> moved(Grid<T> grid, const Position& by) {
  const GridGeometry& from = grid.geometry;
  grid.geometry = GridGeometry(from.resolution(), from.origin() + by, from.width(), from.height());
  return grid;
}

}  // namespace sfw
