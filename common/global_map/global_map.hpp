/// @file The global map: what a floorplan says of its building, as objects and points of the
/// map model. globalmap publishes it, and localize makes the same one from the same file.
///
/// - Walls are surfaces (surfaces.hpp): straight pieces as a laser sees them, free space on their
///   left, as merge keeps its walls. A thin wall between two rooms is two of them, with the same
///   ends and opposite directions: what merge sees of it from either side matches one of them,
///   and its free side says which.
/// - The ends of two walls that meet are connected, and convex or concave as seen from the free
///   space. The end of a wall at an opening, where it has no second face, is convex and not
///   connected. The end of a thin wall connects its two faces.
/// - Each cabinet is one closed object, its corners in clockwise order (free space on the left of
///   each side) beginning with its front: "cabinet 0" is the file's first.
/// - Each door is one object of two points, each projected on the corner of the wall that it ends
///   at. Each start area is one closed object.
///
/// Names count cabinets and doors in the order of the file, by which people call them. All else
/// is in an order that depends on the drawing alone, and so are the ids.
#pragma once

#include <cstdint>

#include "common/floorplan/floorplan.hpp"
#include "common/global_map/free_space.hpp"
#include "common/model/map.hpp"

namespace perceptor::global_map {

struct GlobalMapParameters {
  FreeSpaceParameters free_space;
  double straight_angle = 0.1;  ///< [rad] walls that turn by less are no corner; more leaves flat
                                ///< corners without a kind
};

struct GlobalMap {
  Map map;                     ///< [m] world frame
  std::int64_t id = 0;         ///< content_id(map): the map_id of the message
  double hidden_length = 0.0;  ///< [m] of walls that no free space touches: left out
};

/// Throws TooManyCrossings.
GlobalMap make_global_map(const Floorplan& plan, const GlobalMapParameters& parameters = {});

}  // namespace perceptor::global_map
