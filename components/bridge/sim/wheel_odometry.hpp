/// @file What the wheels believe: the true motion with slip, from a start that is not zero.
#pragma once

#include <cstdint>

#include "common/geometry/position.hpp"
#include "components/bridge/sim/random.hpp"

namespace perceptor::sim {

struct OdometryParameters {
  Position start_in_odometry;     ///< where the wheels believe to be at the start
  double rate = 50.0;             ///< [Hz]
  double slip_scale = 0.01;       ///< each axis is wrong by a factor of 1 +- up to this, drawn
                                  ///< once: the drift that grows with the distance
  double slip_walk = 0.003;       ///< [m/sqrt(m)] scatter that grows with the distance driven
  double slip_turn_walk = 0.003;  ///< [rad/sqrt(rad)] scatter that grows with the angle turned
  double noise = 0.0002;          ///< [m] standard deviation of one reading
  double turn_noise = 0.0002;     ///< [rad] standard deviation of one reading
};

class WheelOdometry {
 public:
  WheelOdometry(const OdometryParameters& parameters, std::uint64_t seed);

  /// The robot moved by this, seen from where it was. No motion, no slip.
  void advance(const Position& motion_in_robot);

  /// Without the noise of a reading; the heading wrapped.
  const Position& robot_in_odometry() const { return robot_in_odometry_; }

  /// One reading of a true state of the wheels.
  Position read(const Position& robot_in_odometry);

 private:
  OdometryParameters parameters_;
  Position robot_in_odometry_;
  double scale_x_;
  double scale_y_;
  double scale_a_;
  Random walk_;
  Random noise_;
};

}  // namespace perceptor::sim
