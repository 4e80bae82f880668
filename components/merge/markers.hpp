/// @file What the local map shows besides walls, for whoever draws it.
#pragma once

#include <vector>

#include "common/model/map.hpp"

namespace perceptor::merge {

/// The origin of the local frame as a point; `map` is in the robot frame.
void add_origin(Map& map, const Position& robot_in_local);

/// The outline of the base, closed.
void add_robot(Map& map, const std::vector<Vector2>& footprint);

/// A closed octagon around the robot's centre whose sides are `distance` [m] away.
void add_safe_distance(Map& map, double distance);

}  // namespace perceptor::merge
