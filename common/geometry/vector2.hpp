/// @file A point or a direction in the plane [m], with the named functions of the
/// Perceptor's data structures. `dot` is Eigen's own member.
#pragma once

#include <Eigen/Core>

namespace perceptor {

using Vector2 = Eigen::Vector2d;

/// Between two points [m].
double distance(const Vector2& a, const Vector2& b);

/// Of the vector [m].
double length(const Vector2& v);

/// Direction of the vector in (-pi, pi] [rad]; 0 for the zero vector.
double angle(const Vector2& v);

/// The z component of the cross product: positive where b lies left of a [m^2].
double cross(const Vector2& a, const Vector2& b);

/// Length one in the same direction; the zero vector stays the zero vector.
Vector2 unit(const Vector2& v);

/// The vector turned by a quarter turn counter-clockwise.
Vector2 perpendicular(const Vector2& v);

/// First rotate by `rotation` [rad] about the origin, then translate.
Vector2 transform(const Vector2& v, double rotation, const Vector2& translation);

}  // namespace perceptor
