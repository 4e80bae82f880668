#include "common/geometry/pose_estimate.hpp"

#include <cmath>

namespace perceptor {
namespace {

double square(double value) { return value * value; }

}  // namespace

PoseEstimate predict(const PoseEstimate& robot_in_frame, const Position& motion, double seconds,
                     const MotionNoise& noise) {
  PoseEstimate predicted;
  predicted.pose = compose(robot_in_frame.pose, motion);
  const Vector2 step = predicted.pose.location() - robot_in_frame.pose.location();
  Eigen::Matrix3d by_pose = Eigen::Matrix3d::Identity();
  by_pose.topRightCorner<2, 1>() = perpendicular(step);
  const double still = square(noise.still) * seconds;
  const double translation = square(noise.translation) * step.norm() + still;
  const double heading = square(noise.heading) * std::abs(motion.a) +
                         square(noise.heading_by_translation) * step.norm() + still;
  predicted.covariance = by_pose * robot_in_frame.covariance * by_pose.transpose();
  predicted.covariance.diagonal() += Eigen::Vector3d(translation, translation, heading);
  return predicted;
}

}  // namespace perceptor
