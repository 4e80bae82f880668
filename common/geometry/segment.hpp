/// @file A straight piece between two points, and what can be said of two of them.
/// The names follow the Perceptor's data structures document.
#pragma once

#include <array>

#include "common/geometry/position.hpp"

namespace perceptor {

struct Segment {
  Vector2 a = Vector2::Zero();  ///< [m] first end
  Vector2 b = Vector2::Zero();  ///< [m] second end
};

/// Direction from a to b, in (-pi, pi]; 0 where the segment has no length.
double angle(const Segment& s);

/// [m]
double length(const Segment& s);

Vector2 middle(const Segment& s);

/// Length one, from a to b; the zero vector where the segment has no length.
Vector2 direction(const Segment& s);

/// Between the two *lines*, whichever way they run: in [0, pi/2]; 0 where either segment has
/// no length.
double smallest_relative_angle(const Segment& s, const Segment& t);

/// From the direction of s to that of t, counter-clockwise: in [0, 2 pi); 0 where
/// either has no length.
double angle_between(const Segment& s, const Segment& t);

/// Signed distance of a point from the line through s: positive on the left of a to b.
/// From the point a where s has no length (then never negative).
double signed_distance(const Segment& s, const Vector2& point);

/// Mean distance of the end points of t from the line through s. One-sided.
double average_perpendicular_distance(const Segment& s, const Segment& t);

/// The same, symmetric: the longer of the two gives the line, and where they are equally long
/// the larger value holds.
double mutual_perpendicular_distance(const Segment& s, const Segment& t);

/// Along the direction of the longer segment, between the nearer ends; 0 where they overlap.
/// Symmetric like the one above. Between the two points where neither has length.
double gap_distance(const Segment& s, const Segment& t);

/// Where along s (in metres from a, towards b) the ends of t fall, the smaller one first;
/// both 0 where s has no length.
std::array<double, 2> projected_interval(const Segment& s, const Segment& t);

/// Distance of a point from the segment itself, ends included.
double distance(const Segment& s, const Vector2& point);

/// Distance [m] between the nearest points of two segments; 0 where they cross.
double distance(const Segment& s, const Segment& t);

/// A segment of frame b, seen from a.
Segment transform(const Position& b_in_a, const Segment& segment_in_b);

}  // namespace perceptor
