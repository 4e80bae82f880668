/// @file A way for the robot through all rooms of a building, and back.
#pragma once

#include <vector>

#include "tools/eval/room_random.hpp"
#include "tools/eval/world_rooms.hpp"

namespace perceptor {

struct WorldTourParameters {
  double approach = 0.5;  ///< [m] before a doorway, where the robot turns into it
  double min_turn = 3.2;  ///< [rad] turned in the middle of a room, to either side
  double max_turn = 5.0;  ///< [rad]
};

struct TourStop {
  Vector2 location = Vector2::Zero();  ///< [m] world frame
  double turn = 0.0;                   ///< [rad] on the spot after arrival
};

/// Begins and ends in the middle of the first room. Each room's middle is visited with a turn;
/// the doorways that are not driven through are driven up to.
std::vector<TourStop> draw_world_tour(const WorldRooms& rooms,
                                      const WorldTourParameters& parameters, RoomRandom& random);

/// The straight pieces of the way, the one back to the beginning included.
std::vector<Segment> legs(const std::vector<TourStop>& tour);

}  // namespace perceptor
