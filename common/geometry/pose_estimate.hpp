/// @file A pose with its uncertainty, moved on by a measured motion.
#pragma once

#include <Eigen/Core>

#include "common/geometry/position.hpp"

namespace perceptor {

/// A pose and how uncertain it is: x, y [m], a [rad] in the frame that it is given in.
struct PoseEstimate {
  Position pose;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// How much a measured motion errs: variances grow with the way and with the turn.
struct MotionNoise {
  double translation = 0.05;             ///< [m / sqrt(m)] after one metre
  double heading = 0.2;                  ///< [rad / sqrt(rad)] after turning by one radian
  double heading_by_translation = 0.03;  ///< [rad / sqrt(m)] after driving one metre
  double still = 0.002;                  ///< [m and rad / sqrt(s)] with time alone
};

/// Moves the estimate on by what was measured in `seconds`; `motion` is seen from the pose before.
PoseEstimate predict(const PoseEstimate& robot_in_frame, const Position& motion, double seconds,
                     const MotionNoise& noise);

}  // namespace perceptor
