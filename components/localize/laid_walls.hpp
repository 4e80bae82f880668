/// @file Walls of the local map, laid on the fronts of the known building.
#pragma once

#include <vector>

#include "common/geometry/position.hpp"
#include "components/localize/local_wall.hpp"
#include "components/localize/world.hpp"

namespace perceptor::localize {

/// How far a wall may be off the front that it lies on.
struct LayTolerance {
  double max_angle = 0.08;   ///< [rad]
  double max_offset = 0.15;  ///< [m]
};

Line transform(const Position& frame_in_new, const Line& line);

/// [m] of the line that lies along a front, doors that may be shut included.
double length_on(const Front& front, const Line& line);

/// [m] of wall that lies on fronts.
double explained_length(const World& world, const std::vector<LocalWall>& walls,
                        const Position& local_in_world, const LayTolerance& tolerance);

/// [m] of walls of at least `long_wall` [m] that do not lie on any front for the greater part:
/// boxes hide what the map has, but long walls that it does not have are rare.
double strange_length(const World& world, const std::vector<LocalWall>& walls,
                      const Position& local_in_world, const LayTolerance& tolerance,
                      double long_wall);

}  // namespace perceptor::localize
