/// @file Which parts of the plane a robot may be in, from the drawing alone.
///
/// 1. The walls, cabinets and doors divide the plane into faces. Where the building is open to
///    the outside, short closing lines (openings.hpp) are added first.
/// 2. Faces that a door or a closing line joins belong together; the outside does so only with
///    what a door leads out of.
/// 3. A face with a place of the start area in it is free; the inside of a cabinet never is.
/// 4. Of the others, what stands in something solid (the building in the world around it, a
///    room in the masonry) is free where it is wide enough or has an opening: what is narrower
///    is the inside of a wall whose two sides are drawn. What stands in free space (a pillar, a
///    wall that stands free) is solid, unless an opening joins it to what is free.
/// 5. The outside is free only where the start area lies in it, where a door leads out, or where
///    nothing else is free: then the drawing shows walls with both their sides, and the outside
///    runs into the rooms.
#pragma once

#include <vector>

#include "common/floorplan/floorplan.hpp"
#include "common/global_map/arrangement.hpp"

namespace perceptor::global_map {

struct FreeSpaceParameters {
  double snap = 0.005;       ///< [m] points nearer than this are one; larger closes chains that are
                             ///< drawn with gaps, and loses what is finer
  double min_width = 0.5;    ///< [m] twice the area over the perimeter: a narrower closed face is
                             ///< masonry; larger takes closets for walls, smaller thick walls
                             ///< for rooms
  double max_opening = 2.0;  ///< [m] wider gaps do not tell inside from outside
};

struct FreeSpace {
  Arrangement arrangement;
  std::vector<bool> is_free;  ///< for each face

  bool is_free_beside(std::size_t half_edge) const { return is_free[arrangement.face(half_edge)]; }
};

/// Throws TooManyCrossings.
FreeSpace find_free_space(const Floorplan& plan, const FreeSpaceParameters& parameters);

}  // namespace perceptor::global_map
