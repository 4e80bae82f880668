/// @file Is the robot in a hallway?
///
/// 1. A side is what lies in one line: walls that are parallel, free towards the robot, and
///    close to each other's line. Pieces count together across gaps no wider than a doorway.
/// 2. Two sides make a hallway where they face each other and the robot is between them: the
///    width within limits, and long enough where both stand.
/// 3. It ends where a wall crosses its centre line. Nothing stands across between the robot
///    and either side.
/// 4. Of several the narrowest: what the robot touches first on both sides. Those about as
///    wide are one, seen along different walls; then the longest wall gives the direction.
///
/// Whether the ends are open does not count: a dead end is a hallway too, and so is a room
/// that is long and narrow enough.
#pragma once

#include <optional>
#include <vector>

#include "components/identify/walls.hpp"

namespace perceptor::identify {

struct HallwayParameters {
  double max_angle = 0.1;       ///< [rad] of a wall with the centre line
  double min_width = 0.6;       ///< [m] less is no place to drive
  double max_width = 3.0;       ///< [m] more takes rooms for hallways
  double min_length = 1.5;      ///< [m] where both sides stand; less takes deep doorways
  double min_elongation = 1.5;  ///< [-] length over width; less takes rooms
  double max_gap = 1.5;         ///< [m] a doorway in a side; more bridges side corridors
  double max_offset = 0.1;      ///< [m] of a wall from the line of its side
  double min_cover = 0.5;       ///< [-] of the length that must be wall, on each side
  double reach = 15.0;          ///< [m] ahead and behind the robot; the centre line ends there
};

/// A hallway, in the frame of the walls.
struct Hallway {
  Vector2 back = Vector2::Zero();   ///< [m] the centre line's end with the smaller x
  Vector2 front = Vector2::Zero();  ///< [m] and the other one, ahead in the robot frame
  double width = 0.0;               ///< [m] between the sides, mean
};

/// `robot`: [m] in the walls' frame. Walls whose free side is not known belong to no side,
/// but stand in the way.
std::optional<Hallway> find_hallway(const std::vector<Wall>& walls, const Vector2& robot,
                                    const HallwayParameters& parameters = {});

}  // namespace perceptor::identify
