/// @file What belongs to the robot itself: said once, in robot.json, and read by all.
#pragma once

#include <vector>

#include "common/config/fields.hpp"
#include "common/geometry/position.hpp"

namespace perceptor {

struct FootprintCorner {
  double x = 0.0;  ///< [m] robot frame
  double y = 0.0;  ///< [m] robot frame
};

struct RobotLimits {
  double speed = 0.5;                 ///< [m/s] in any direction
  double turn_rate = 1.2;             ///< [rad/s]
  double acceleration = 1.0;          ///< [m/s^2] in any direction
  double angular_acceleration = 3.0;  ///< [rad/s^2]
};

struct LaserMounting {
  Position laser_in_robot;    ///< where the laser is mounted
  double range_sigma = 0.01;  ///< [m] standard deviation of a valid range
  double valid_min = 0.01;    ///< [m] shorter is "no return"
  double valid_max = 10.0;    ///< [m] longer is "no return"
};

struct Robot {
  /// Outline of the base, counter-clockwise, at least three corners. PICO: an octagon
  /// within 0.41 m (along) by 0.35 m (across).
  std::vector<FootprintCorner> footprint = {{0.205, 0.075},  {0.105, 0.175},   {-0.105, 0.175},
                                            {-0.205, 0.075}, {-0.205, -0.075}, {-0.105, -0.175},
                                            {0.105, -0.175}, {0.205, -0.075}};
  RobotLimits limits;
  LaserMounting laser;
};

/// The footprint's corners [m], robot frame.
std::vector<Vector2> outline(const Robot& robot);

void describe(config::Fields& fields, Position& position);
void describe(config::Fields& fields, FootprintCorner& corner);
void describe(config::Fields& fields, RobotLimits& limits);
void describe(config::Fields& fields, LaserMounting& laser);
void describe(config::Fields& fields, Robot& robot);

}  // namespace perceptor
