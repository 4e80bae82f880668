#include "common/geometry/vector2.hpp"

#include <cmath>

#include "common/geometry/angle.hpp"

namespace perceptor {

double distance(const Vector2& a, const Vector2& b) { return length(b - a); }

// hypot, because the square of a small component would vanish.
double length(const Vector2& v) { return std::hypot(v.x(), v.y()); }

double angle(const Vector2& v) {
  const bool is_zero = v.x() == 0.0 && v.y() == 0.0;
  if (is_zero) return 0.0;  // atan2 would tell -0 from 0
  return wrap_angle(std::atan2(v.y(), v.x()));
}

double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

Vector2 unit(const Vector2& v) {
  const double norm = length(v);
  if (norm == 0.0) return Vector2::Zero();
  return v / norm;
}

Vector2 perpendicular(const Vector2& v) { return {-v.y(), v.x()}; }

Vector2 transform(const Vector2& v, double rotation, const Vector2& translation) {
  const double c = std::cos(rotation);
  const double s = std::sin(rotation);
  return {c * v.x() - s * v.y() + translation.x(), s * v.x() + c * v.y() + translation.y()};
}

}  // namespace perceptor
