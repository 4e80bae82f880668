/// @file What is added to a room: what bends one of its walls, and what stands free in it. All
/// dimensions are random.
///
/// Each `add_` keeps the plan sound: where its part finds no place in some attempts, the plan
/// stays as it was.
#pragma once

#include <cstddef>
#include <vector>

#include "tools/eval/floor_plan.hpp"
#include "tools/eval/room_random.hpp"

namespace perceptor {

/// Between its ends the wall now runs through `path`, whose points count along the wall from its
/// first corner (x) and into the free space (y) [m].
void bend_wall(Outline& outline, std::size_t wall, const std::vector<Vector2>& path);

/// A room behind a doorway; all places along the wall that the doorway is in.
struct RoomBehind {
  double begin = 0.0;       ///< [m]
  double end = 0.0;         ///< [m]
  double door_begin = 0.0;  ///< [m] not before the room's
  double door_end = 0.0;    ///< [m] not after the room's
  double thickness = 0.1;   ///< [m] of the wall
  double depth = 3.0;       ///< [m] of the room
};

/// For bend_wall.
std::vector<Vector2> path_of(const RoomBehind& room);

/// A doorway of 0.7 to 1.2 m in a room that is wider than 1.5 m.
void place_door(RoomRandom& random, RoomBehind& room);

/// [m] 0.1 to 0.2.
double wall_thickness(RoomRandom& random);

/// A corridor out of the room, 0.7 to 1.4 m wide and 1.5 to 5 m long, closed at its end.
void add_exit(RoomRandom& random, FloorPlan& plan);

/// A second room behind a doorway.
void add_room_behind(RoomRandom& random, FloorPlan& plan);

/// A niche or a pillar in a wall, 0.1 to 0.3 m deep and 0.3 to 1.5 m wide.
void add_recess(RoomRandom& random, FloorPlan& plan);

/// A wall 0.05 to 0.15 m thick and 0.8 to 2.5 m long that grows out of another and ends in the
/// room.
void add_partition(RoomRandom& random, FloorPlan& plan);

/// The same, standing free, in any direction.
void add_free_partition(RoomRandom& random, FloorPlan& plan);

/// A box against a wall, sides of 0.3 to 1.5 m.
void add_cabinet(RoomRandom& random, FloorPlan& plan);

/// A box that stands free, sides of 0.3 to 1.5 m; every other one is turned.
void add_box(RoomRandom& random, FloorPlan& plan);

/// A polygon_thing that stands free.
void add_polygon(RoomRandom& random, FloorPlan& plan);

}  // namespace perceptor
