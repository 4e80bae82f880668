#include "components/bridge/sim/wheel_odometry.hpp"

#include <cmath>

#include "common/geometry/angle.hpp"

namespace perceptor::sim {
namespace {

/// Standard normal; without the value that std::normal_distribution keeps for next time.
double normal(Random& random) { return std::normal_distribution<double>()(random); }

}  // namespace

WheelOdometry::WheelOdometry(const OdometryParameters& parameters, std::uint64_t seed)
    : parameters_(parameters),
      robot_in_odometry_(parameters.start_in_odometry),
      walk_(make_stream(seed, Stream::slip_walk)),
      noise_(make_stream(seed, Stream::encoder_noise)) {
  Random scales = make_stream(seed, Stream::slip_scale);
  std::uniform_real_distribution<double> error(-1.0, 1.0);
  scale_x_ = 1.0 + (parameters.slip_scale * error(scales));
  scale_y_ = 1.0 + (parameters.slip_scale * error(scales));
  scale_a_ = 1.0 + (parameters.slip_scale * error(scales));
  robot_in_odometry_.a = wrap_angle(robot_in_odometry_.a);
}

void WheelOdometry::advance(const Position& motion_in_robot) {
  // Independent steps whose variance grows with the way: the sum over a metre has the same
  // scatter however finely the way is cut.
  const double walk = parameters_.slip_walk * std::sqrt(motion_in_robot.location().norm());
  const double turn_walk = parameters_.slip_turn_walk * std::sqrt(std::abs(motion_in_robot.a));
  const Position believed{(motion_in_robot.x * scale_x_) + (walk * normal(walk_)),
                          (motion_in_robot.y * scale_y_) + (walk * normal(walk_)),
                          (motion_in_robot.a * scale_a_) + (turn_walk * normal(walk_))};
  robot_in_odometry_ = compose(robot_in_odometry_, believed);
}

Position WheelOdometry::read(const Position& robot_in_odometry) {
  const Position noise{parameters_.noise * normal(noise_), parameters_.noise * normal(noise_),
                       parameters_.turn_noise * normal(noise_)};
  return robot_in_odometry + noise;
}

}  // namespace perceptor::sim
