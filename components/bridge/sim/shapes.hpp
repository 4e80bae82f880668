/// @file Outlines of bodies in the plane, and whether they touch.
#pragma once

#include <vector>

#include "common/geometry/polygon.hpp"
#include "common/geometry/segment.hpp"

namespace perceptor::sim {

struct Circle {
  Vector2 centre = Vector2::Zero();  ///< [m]
  double radius = 0.0;               ///< [m]
};

/// Corners in order, either way round; the last is joined to the first.
using Polygon = std::vector<Vector2>;

/// A rotated rectangle.
struct Box {
  Position box_in_world;  ///< its middle; x along its length
  double length = 0.5;    ///< [m]
  double width = 0.5;     ///< [m]
};

Polygon outline(const Box& box);

/// A polygon of frame b, seen from a.
Polygon transform(const Position& b_in_a, const Polygon& polygon_in_b);

/// Distance of its farthest corner from the origin [m].
double radius_of(const Polygon& polygon);

/// Whether two segments have a point in common. Parallel ones count as apart, even on one line:
/// then the edges beside them tell.
bool cross_each_other(const Segment& s, const Segment& t);

/// Whether a filled polygon and a segment have a point in common.
bool touches(const Polygon& polygon, const Segment& segment);

/// Whether a filled polygon and a filled circle have a point in common.
bool touches(const Polygon& polygon, const Circle& circle);

}  // namespace perceptor::sim
