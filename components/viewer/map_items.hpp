/// @file Maps as marks in a picture. All in the map's own frame.
#pragma once

#include <vector>

#include "common/model/map.hpp"
#include "components/viewer/scene.hpp"

namespace perceptor::viewer {

/// Its walls.
std::vector<Item> current_map_items(const Map& current_map);

/// Its walls, and where it began.
std::vector<Item> local_map_items(const Map& local_map);

/// Corners by their property, doors with a label, possible doors. Two ends that form one corner
/// give one mark.
std::vector<Item> identified_items(const Map& identified_map);

/// The robot's outline and the safe distance around it, as they stand in a local map.
std::vector<Item> robot_items(const Map& local_map);

/// Walls, cabinets, doors, the start area.
std::vector<Item> global_map_items(const Map& global_map);

/// Walls, cabinets and doors by what was found of them.
std::vector<Item> combined_map_items(const Map& combined_map);

/// What is not on the map of the building.
std::vector<Item> obstacle_items(const Map& combined_map);

/// Everything that stands in the simulated world; an open door does not.
std::vector<Item> true_world_items(const Map& world);

}  // namespace perceptor::viewer
