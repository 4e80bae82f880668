/// @file The pose of one frame in another, an element of SE(2).
#pragma once

#include "common/geometry/vector2.hpp"

namespace perceptor {

/// The pose of one frame seen from another. The variable that holds it names both:
/// `robot_in_zero`.
struct Position {
  double x = 0.0;  ///< [m] forward
  double y = 0.0;  ///< [m] left
  double a = 0.0;  ///< [rad] heading in (-pi, pi]

  Vector2 location() const { return {x, y}; }

  friend bool operator==(const Position&, const Position&) = default;
};

/// Component by component, the heading wrapped: simple arithmetic, not composition.
Position operator+(const Position& p, const Position& q);
Position operator-(const Position& p, const Position& q);

/// `b_in_a` and `c_in_b` give `c_in_a`.
Position compose(const Position& b_in_a, const Position& c_in_b);

/// `b_in_a` gives `a_in_b`.
Position inverse(const Position& b_in_a);

/// The pose of b seen from a, both seen from a third frame: inverse(a) composed with b.
Position relative(const Position& a_in_world, const Position& b_in_world);

/// A point of frame b, seen from a.
Vector2 transform(const Position& b_in_a, const Vector2& point_in_b);

/// Between two poses: `fraction` 0 gives p, 1 gives q; the heading goes the short way
/// round. Fractions outside [0, 1] extrapolate.
Position interpolate(const Position& p, const Position& q, double fraction);

bool is_finite(const Position& p);

}  // namespace perceptor
