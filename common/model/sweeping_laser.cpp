#include "common/model/sweeping_laser.hpp"

#include <cmath>

namespace perceptor {
namespace {

/// A slower turn [rad/s] bends the way of no sweep by as much as rounding does.
constexpr double kSlowestTurn = 1e-12;

}  // namespace

SweepingLaser::SweepingLaser(const Position& laser_in_robot, const Twist& twist,
                             double time_increment)
    : start_(laser_in_robot.location()),
      turns_(std::abs(twist.va) > kSlowestTurn && time_increment != 0.0) {
  const Vector2 velocity(twist.vx, twist.vy);
  if (!turns_) {
    step_ = time_increment * velocity;
    return;
  }
  along_circle_ = velocity / twist.va + perpendicular(start_);
  to_centre_ = perpendicular(along_circle_);
  const double half_step = 0.5 * twist.va * time_increment;
  step_cosine_ = std::cos(half_step);
  step_sine_ = std::sin(half_step);
}

SweepingLaser::Place SweepingLaser::next() {
  if (!turns_) return {start_ + beam_++ * step_, 1.0, 0.0};
  // Both sin(turn) and 1 - cos(turn) without cancellation, from half of the turn.
  const double sine = 2.0 * half_sine_ * half_cosine_;
  const double versine = 2.0 * half_sine_ * half_sine_;
  const double half_cosine = half_cosine_ * step_cosine_ - half_sine_ * step_sine_;
  half_sine_ = half_sine_ * step_cosine_ + half_cosine_ * step_sine_;
  half_cosine_ = half_cosine;
  return {start_ + sine * along_circle_ + versine * to_centre_, 1.0 - versine, sine};
}

}  // namespace perceptor
