/// @file The outlines of what is occupied, where free space lies beside them.
#pragma once

#include <vector>

#include "tools/vectorize/occupancy_grid.hpp"

namespace perceptor {

/// Places along an outline, free space on their left.
struct Outline {
  std::vector<Vector2> places;  ///< [m] world frame, the middles of cells' sides
  bool is_closed = false;       ///< the last is followed by the first
};

/// `reach`: so many unknown cells may lie between what is free and what is occupied. Cells that
/// touch at a corner count as joined: thin slanted walls stay whole.
std::vector<Outline> trace_outlines(const OccupancyGrid& grid, int reach);

}  // namespace perceptor
