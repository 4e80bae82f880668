/// @file A floorplan out of an occupancy grid.
#pragma once

#include "common/floorplan/floorplan.hpp"
#include "tools/vectorize/occupancy_grid.hpp"

namespace perceptor {

/// Where the surface of a wall is.
enum class Surface {
  edge,   ///< where occupied cells begin: drawn plans
  middle  ///< in the middle of the occupied band: maps made of scans, which smear a wall
};

struct VectorizeParameters {
  Surface surface = Surface::edge;
  double thickest = 1.0;    ///< [m] of a band; thicker is solid, and its surface the edge
  double tolerance = 1.0;   ///< cells by which a wall may be off its outline
  double min_length = 0.3;  ///< [m] outlines shorter than this are specks
  int reach = 2;            ///< unknown cells between what is free and what is occupied
};

/// Walls where free and occupied cells face each other, and a small start area in the middle of
/// the widest free space: it tells inside from outside where the walls do not close.
Floorplan vectorize(const OccupancyGrid& grid, const VectorizeParameters& parameters = {});

}  // namespace perceptor
