/// @file The surfaces of a building as a laser in its free space sees them: straight pieces,
/// free space on the left of each, in the order in which they follow each other around the free
/// space. A wall that is free on both sides is two of them; what no free space touches is none.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "common/global_map/free_space.hpp"

namespace perceptor::global_map {

struct Surface {
  Segment segment;                  ///< [m] free space on the left of a to b
  int cabinet = kNoCabinet;         ///< whose side it is; none: a wall
  std::size_t next = kNowhere;      ///< the surface that meets its end b in a corner
  std::size_t previous = kNowhere;  ///< the one that meets its end a
};

struct SurfaceParameters {
  double snap = 0.005;  ///< [m] pieces in one line become one surface, if the points between
                        ///< them are no farther from it
  double straight_angle = 0.1;  ///< [rad] only pieces that turn by less
};

struct Surfaces {
  std::vector<Surface> surfaces;
  double hidden_length = 0.0;  ///< [m] of walls that no free space touches
};

/// In an order that depends on the drawing alone: along each boundary of free space, from the
/// corner that is first from the left (of several, the lowest).
Surfaces find_surfaces(const FreeSpace& space, const SurfaceParameters& parameters);

/// What a corner turns by, from one surface to the next [rad], in (-pi, pi]: positive where the
/// free space is less than half of the turn around it (concave). The end of a thin wall, where
/// the next surface leads back, gives -pi.
double turn_between(const Surface& surface, const Surface& next);

}  // namespace perceptor::global_map
