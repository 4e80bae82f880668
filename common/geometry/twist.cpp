#include "common/geometry/twist.hpp"

#include <cmath>

#include "common/geometry/angle.hpp"

namespace perceptor {

Position move(const Twist& twist, double seconds) {
  const double turn = twist.va * seconds;
  const Vector2 travel{twist.vx * seconds, twist.vy * seconds};
  // sin(a) / a and (1 - cos(a)) / a, the latter without the cancellation at small angles.
  double along = 1.0;
  double across = 0.0;
  if (turn != 0.0) {
    const double half_sine = std::sin(0.5 * turn);
    along = std::sin(turn) / turn;
    across = 2.0 * half_sine * half_sine / turn;
  }
  const Vector2 moved = along * travel + across * perpendicular(travel);
  return {moved.x(), moved.y(), wrap_angle(turn)};
}

Twist twist_between(const Position& from_in_world, const Position& to_in_world, double seconds) {
  const bool time_passes = seconds > 0.0;
  if (!time_passes) return {};
  const Position to_in_from = relative(from_in_world, to_in_world);
  const double half = 0.5 * to_in_from.a;
  const double half_over_tangent = half == 0.0 ? 1.0 : half * std::cos(half) / std::sin(half);
  const Vector2 travel =
      half_over_tangent * to_in_from.location() - half * perpendicular(to_in_from.location());
  return {travel.x() / seconds, travel.y() / seconds, to_in_from.a / seconds};
}

}  // namespace perceptor
