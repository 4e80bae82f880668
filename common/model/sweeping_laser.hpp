/// @file Where a laser is while it sweeps and the robot moves.
#pragma once

#include "common/geometry/twist.hpp"

namespace perceptor {

/// The laser from beam to beam while the robot moves at constant twist: the same as
/// compose(move(twist, beam * time_increment), laser_in_robot), for thousands of beams a sweep.
/// A robot that turns does so about a centre, and its laser goes round that in a circle; from
/// beam to beam by the same angle, so that no sine is computed twice.
class SweepingLaser {
 public:
  /// Seen from the robot at the time of the first beam.
  struct Place {
    Vector2 origin;  ///< [m]
    double cosine;   ///< of the turn since the first beam
    double sine;     ///< of the same
  };

  /// `time_increment` [s] from beam to beam.
  SweepingLaser(const Position& laser_in_robot, const Twist& twist, double time_increment);

  /// Whether the laser is where it was at the first beam, whatever the beam.
  bool stands() const { return !turns_ && step_.x() == 0.0 && step_.y() == 0.0; }

  /// At the first beam, then one beam later with each call.
  Place next();

 private:
  Vector2 start_;  // [m]
  bool turns_;
  Vector2 step_ = Vector2::Zero();          // [m] from beam to beam, without a turn
  Vector2 along_circle_ = Vector2::Zero();  // [m] the circle's radius, in the direction of motion
  Vector2 to_centre_ = Vector2::Zero();     // [m] the circle's radius, from the start
  double step_cosine_ = 1.0;                // of half the turn from beam to beam
  double step_sine_ = 0.0;
  double half_cosine_ = 1.0;  // of half the turn up to the next beam
  double half_sine_ = 0.0;
  double beam_ = 0.0;  // the next
};

}  // namespace perceptor
