/// @file Random rooms, and a place in them for the robot.
#pragma once

#include <array>

#include "tools/eval/floor_plan.hpp"
#include "tools/eval/room_random.hpp"

namespace perceptor {

enum class RoomKind {
  escape,       ///< a rectangle with a corridor as its exit
  l_shape,      ///< an L with another room behind a doorway
  corridor,     ///< a corridor with rooms on both sides, through doorways
  slanted,      ///< obtuse and acute corners, some things in between
  cluttered,    ///< cabinets, boxes and polygons
  partitioned,  ///< thin walls that end in the room
  recessed      ///< shallow niches and pillars
};

inline constexpr std::array kAllRoomKinds{
    RoomKind::escape,    RoomKind::l_shape,     RoomKind::corridor, RoomKind::slanted,
    RoomKind::cluttered, RoomKind::partitioned, RoomKind::recessed};

/// A sound plan (see is_sound) with dimensions of its own.
FloorPlan make_room(RoomKind kind, RoomRandom& random);

/// Anywhere in the free space, at least `min_clearance` [m] from every wall, with any heading.
/// Throws std::runtime_error where there is hardly such a place.
Position free_pose(const FloorPlan& plan, RoomRandom& random, double min_clearance = 0.3);

}  // namespace perceptor
