/// @file The walls of merge as a Map of the model.
#pragma once

#include <vector>

#include "components/merge/wall.hpp"

namespace perceptor::merge {

/// The confirmed walls, seen from the robot: objects in the order of `walls`, each with its tail
/// and head as points, corners connected. `end_sigma` [m]: an end known this well has weight 1.
Map confirmed_map(const std::vector<Wall>& walls, const Position& robot_in_local, double end_sigma);

}  // namespace perceptor::merge
