/// @file Random buildings for the simulator: rows of rooms between straight walls that need not be
/// parallel, doorways in the walls that two rooms share.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "common/geometry/segment.hpp"
#include "tools/eval/room_random.hpp"

namespace perceptor {

struct WorldRoomParameters {
  double min_thickness = 0.1;     ///< [m] of a wall; each has its own
  double max_thickness = 0.2;     ///< [m]
  double min_door = 0.5;          ///< [m] width of an opening
  double max_door = 1.5;          ///< [m]
  double max_extra_door = 1.1;    ///< [m] of those that are not driven through: some are narrow
  double min_driven_door = 0.85;  ///< [m] of the doorways that connect all rooms
  double door_margin = 0.4;       ///< [m] of wall beside a doorway, at least
  double extra_doors = 0.8;       ///< share of the other walls that have a doorway as well
  double max_row_slant = 0.06;    ///< [m/m] of the walls along the building
  double max_cross_slant = 0.35;  ///< [m] between the ends of a wall across it
  double corridors = 0.75;        ///< share of buildings with a corridor
  double min_corridor = 1.4;      ///< [m] between the middles of its walls
  double max_corridor = 1.75;     ///< [m]
  double chamfers = 0.12;         ///< share of the corners of rooms that are cut off
  double min_chamfer = 0.5;       ///< [m] cut off each of the two walls
  double max_chamfer = 0.8;       ///< [m]
  std::size_t min_rooms = 4;      ///< in a building
  std::size_t max_rooms = 6;
  double turned = 0.5;  ///< share of buildings that stand turned in the world
};

/// One side of a room; the room lies on the left of a to b.
struct RoomSide {
  Segment segment;  ///< [m] world frame
  int line = -1;    ///< which wall it is a face of; -1: a corner cut off
};

/// Convex; its sides run counter-clockwise.
struct WorldRoom {
  std::vector<RoomSide> sides;
  bool is_corridor = false;
};

/// An opening between two rooms. Each face runs along the wall, both in the same direction, so
/// that the jambs join a to a and b to b.
struct Doorway {
  std::size_t room = 0;        ///< that of `face`
  std::size_t other_room = 0;  ///< that of `other_face`
  Segment face;                ///< [m] world frame
  Segment other_face;          ///< [m] world frame
  bool is_driven = false;      ///< one of those that connect all rooms
};

struct WorldRooms {
  std::vector<WorldRoom> rooms;
  std::vector<Doorway> doorways;
};

/// Four to six rooms that can all be reached through driven doorways. None where the numbers
/// drawn do not fit together: draw again.
std::optional<WorldRooms> draw_world_rooms(const WorldRoomParameters& parameters,
                                           RoomRandom& random);

/// The faces of all walls with the doorways cut out, and the jambs.
std::vector<Segment> walls(const WorldRooms& rooms);

/// The mean of the room's corners.
Vector2 centre(const WorldRoom& room);

}  // namespace perceptor
