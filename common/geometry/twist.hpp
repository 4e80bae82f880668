/// @file How fast a frame moves, seen from itself.
#pragma once

#include "common/geometry/position.hpp"

namespace perceptor {

/// Velocity of the robot in its own frame.
struct Twist {
  double vx = 0.0;  ///< [m/s] forward
  double vy = 0.0;  ///< [m/s] left
  double va = 0.0;  ///< [rad/s]
};

/// The pose reached after `seconds` at constant twist, seen from the pose at the start
/// (the exponential map of SE(2)). Negative seconds go back.
Position move(const Twist& twist, double seconds);

/// The constant twist that leads from one pose to another in `seconds` (the logarithm of
/// SE(2)); zero where seconds <= 0.
Twist twist_between(const Position& from_in_world, const Position& to_in_world, double seconds);

}  // namespace perceptor
