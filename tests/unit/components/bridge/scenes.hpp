/// @file Small worlds for the tests of the simulator.
#pragma once

#include <vector>

#include "components/bridge/sim/simulator.hpp"

namespace perceptor::sim {

/// Four walls around the origin, each `half` metres away.
inline std::vector<Segment> square_room(double half) {
  return edges({{half, half}, {-half, half}, {-half, -half}, {half, -half}});
}

/// A robot of 0.4 by 0.4 m.
inline Polygon square_footprint() { return {{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}}; }

/// A perfect laser.
inline LaserParameters exact_laser() {
  LaserParameters laser;
  laser.noise_sigma = 0.0;
  return laser;
}

/// Perfect wheels.
inline OdometryParameters exact_wheels() {
  OdometryParameters wheels;
  wheels.slip_scale = wheels.slip_walk = wheels.slip_turn_walk = 0.0;
  wheels.noise = wheels.turn_noise = 0.0;
  return wheels;
}

/// A perfect robot, driven by commands, in the middle of a room of 8 by 8 m.
inline SimulatorParameters exact_simulator() {
  SimulatorParameters parameters;
  parameters.world.walls = square_room(4.0);
  parameters.base.footprint = square_footprint();
  parameters.laser = exact_laser();
  parameters.odometry = exact_wheels();
  parameters.drive = Drive::command;
  return parameters;
}

}  // namespace perceptor::sim
