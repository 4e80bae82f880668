#include "components/locate/zero_frame.hpp"

#include <algorithm>
#include <cmath>

#include "common/geometry/angle.hpp"

namespace perceptor {
namespace {

bool is_at_origin(const Position& robot_in_odometry, const ZeroFrameParameters& parameters) {
  return length(robot_in_odometry.location()) <= parameters.origin_radius &&
         std::abs(robot_in_odometry.a) <= parameters.origin_heading;
}

/// The pose of the zero frame for which the robot, now here in the odometry frame, is where it
/// was in zero.
Position moved_along(const Position& robot_in_odometry, const Position& robot_in_zero) {
  return compose(robot_in_odometry, inverse(robot_in_zero));
}

}  // namespace

OdometryStep classify_step(const Position& from_in_odometry, const Position& to_in_odometry,
                           double seconds, const ZeroFrameParameters& parameters) {
  const double driving_time = std::max(seconds, 0.0);
  const double driven = distance(from_in_odometry.location(), to_in_odometry.location());
  const double turned = std::abs(angle_difference(from_in_odometry.a, to_in_odometry.a));

  const bool is_within_slack =
      driven <= parameters.distance_slack && turned <= parameters.heading_slack;
  if (is_within_slack) return OdometryStep::driven;
  if (is_at_origin(to_in_odometry, parameters)) return OdometryStep::switched_on_anew;

  const bool is_drivable =
      driven <= parameters.max_speed * driving_time + parameters.distance_slack &&
      turned <= parameters.max_turn_rate * driving_time + parameters.heading_slack;
  return is_drivable ? OdometryStep::driven : OdometryStep::jumped;
}

ZeroPosition ZeroFrame::update(std::int64_t utime, const Position& robot_in_odometry,
                               bool began_anew) {
  ZeroPosition now;
  if (!last_ || began_anew) {
    now.zero_utime = utime;
    now.zero_in_odometry = robot_in_odometry;
  } else {
    now = last_->position;
    const double seconds = 1e-6 * static_cast<double>(utime - last_->utime);
    now.step = classify_step(last_->robot_in_odometry, robot_in_odometry, seconds, parameters_);
    if (now.step == OdometryStep::driven) {
      now.robot_in_zero = relative(now.zero_in_odometry, robot_in_odometry);
    } else {
      now.zero_in_odometry = moved_along(robot_in_odometry, now.robot_in_zero);
      ++now.bridged;
    }
  }
  last_ = Last{.utime = utime, .robot_in_odometry = robot_in_odometry, .position = now};
  return now;
}

}  // namespace perceptor
