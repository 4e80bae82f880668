/// @file The omni-wheel base: limited in speed and acceleration, and stopped by what it
/// touches.
#pragma once

#include <functional>

#include "common/geometry/twist.hpp"
#include "components/bridge/sim/obstacles.hpp"

namespace perceptor::sim {

struct BaseParameters {
  Polygon footprint;                  ///< [m] robot frame
  double speed = 0.5;                 ///< [m/s] in any direction
  double turn_rate = 1.2;             ///< [rad/s]
  double acceleration = 1.0;          ///< [m/s^2] in any direction
  double angular_acceleration = 3.0;  ///< [rad/s^2]
};

class Base {
 public:
  Base(const BaseParameters& parameters, const Position& robot_in_world);

  /// Follows the wished velocity for `seconds`, as far as limits and obstacles let it. It slides
  /// along what it would run into, or stops. Where something already stands in the footprint (a
  /// person who walked into it), the base does not move.
  void advance(const Twist& wished, double seconds, const Obstacles& obstacles);

  const Position& robot_in_world() const { return robot_in_world_; }
  const Twist& twist() const { return twist_; }  ///< robot frame

  /// Whether the base stands against something: from the touch until it moves freely again.
  bool in_collision() const { return in_collision_; }

  /// Whether the base would touch this segment where it stands.
  bool would_touch(const Segment& segment) const;

 private:
  Twist next_twist(const Twist& wished, double seconds) const;
  /// The step towards `goal` that is left where `surface` is in the way.
  Position way_out(const Position& goal, const Vector2& surface,
                   const std::function<bool(const Position&)>& is_free) const;

  BaseParameters parameters_;
  double reach_;  ///< [m] of the footprint's farthest corner
  Position robot_in_world_;
  Twist twist_;
  bool in_collision_ = false;
};

}  // namespace perceptor::sim
