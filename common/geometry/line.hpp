/// @file The axes of a segment, computed once for many comparisons.
#pragma once

#include "common/geometry/interval.hpp"
#include "common/geometry/segment.hpp"

namespace perceptor {

struct Line {
  Vector2 middle = Vector2::Zero();
  Vector2 along = Vector2::Zero();   ///< unit vector from a to b
  Vector2 normal = Vector2::Zero();  ///< unit vector to the left
  double length = 0.0;               ///< [m]
};

Line line_of(const Segment& segment);

/// From the direction of one line to that of the other, in (-pi, pi].
double turn_between(const Line& from, const Line& to);

/// [m] along the line, from its middle.
double place_on(const Line& line, const Vector2& point);

/// The inverse of place_on.
Vector2 point_at(const Line& line, double place);

/// [m] along the line, from its middle: where it is itself, and what another one covers of it.
Interval extent_of(const Line& line);
Interval extent_on(const Line& line, const Line& other);

}  // namespace perceptor
