/// @file What the simulator measures and knows, as messages. Stamps are the caller's.
#pragma once

#include <cstdint>
#include <vector>

#include <pico/laser_scan_t.hpp>
#include <pico/map_t.hpp>
#include <pico/odometry_t.hpp>
#include <pico/truth_t.hpp>

#include "common/config/robot.hpp"
#include "components/bridge/sim/simulator.hpp"

namespace perceptor {

/// What the robot's configuration says of the laser goes along, not what is so in the world.
pico::laser_scan_t to_message(const sim::Sweep& sweep, const sim::LaserParameters& laser,
                              const LaserMounting& mounting);

pico::odometry_t to_message(const sim::OdometryReading& reading);

pico::truth_t to_message(const sim::Truth& truth);

/// What stands in the world, in as many parts as fit: walls and edges of cabinets, doors with
/// their state ("open", "shut") as their reason, boxes as static obstacles.
std::vector<pico::map_t> to_messages(const sim::World& world,
                                     const std::vector<sim::DoorState>& doors);

}  // namespace perceptor
