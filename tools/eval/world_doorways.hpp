/// @file Doorways between the rooms of a random building.
#pragma once

#include <vector>

#include "tools/eval/wall_line.hpp"
#include "tools/eval/world_rooms.hpp"

namespace perceptor {

/// Wide ones until each room can be reached from each other, and some more. False where not all
/// can be joined. `lines`: the walls, by the index that the rooms' sides name.
bool add_doorways(WorldRooms& rooms, const std::vector<WallLine>& lines,
                  const WorldRoomParameters& parameters, RoomRandom& random);

}  // namespace perceptor
