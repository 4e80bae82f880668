#include "common/geometry/position.hpp"

#include <cmath>

#include "common/geometry/angle.hpp"

namespace perceptor {

Position operator+(const Position& p, const Position& q) {
  return {p.x + q.x, p.y + q.y, wrap_angle(p.a + q.a)};
}

Position operator-(const Position& p, const Position& q) {
  return {p.x - q.x, p.y - q.y, wrap_angle(p.a - q.a)};
}

Position compose(const Position& b_in_a, const Position& c_in_b) {
  const Vector2 c_location = transform(b_in_a, c_in_b.location());
  return {c_location.x(), c_location.y(), wrap_angle(b_in_a.a + c_in_b.a)};
}

Position inverse(const Position& b_in_a) { return relative(b_in_a, Position{}); }

// The difference is taken before it is rotated: two poses close to each other and far from
// the origin keep their digits.
Position relative(const Position& a_in_world, const Position& b_in_world) {
  const Vector2 a_to_b = b_in_world.location() - a_in_world.location();
  const Vector2 b_in_a = transform(a_to_b, -a_in_world.a, Vector2::Zero());
  return {b_in_a.x(), b_in_a.y(), wrap_angle(b_in_world.a - a_in_world.a)};
}

Vector2 transform(const Position& b_in_a, const Vector2& point_in_b) {
  return transform(point_in_b, b_in_a.a, b_in_a.location());
}

Position interpolate(const Position& p, const Position& q, double fraction) {
  const double turn = angle_difference(p.a, q.a);
  // From the nearer end, so that both ends are met to the last digit.
  const double heading = fraction < 0.5 ? p.a + fraction * turn : q.a - (1.0 - fraction) * turn;
  return {std::lerp(p.x, q.x, fraction), std::lerp(p.y, q.y, fraction), wrap_angle(heading)};
}

bool is_finite(const Position& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.a);
}

}  // namespace perceptor
