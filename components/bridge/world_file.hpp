/// @file World files: what the simulator adds to a map. Doors, boxes, people, noise, slip, where
/// the robot starts and the tour it drives.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/config/robot.hpp"
#include "components/bridge/sim/simulator.hpp"

namespace perceptor {

/// Finds a world by its file, or by its name in the folder `worlds` of the configuration
/// ("hospital"). Throws config::Error, which lists the worlds there are.
std::filesystem::path find_world(const std::string& world, const std::filesystem::path& config_dir);

namespace sim {
/// What the robot's own configuration says, in an empty world.
SimulatorParameters parameters_of(const Robot& robot);
}  // namespace sim

/// Reads a world file and the map that it names. What the file leaves open of the laser, and
/// all of the base, is the robot's. Throws config::Error.
sim::SimulatorParameters read_world(const std::filesystem::path& file, const Robot& robot);

}  // namespace perceptor
