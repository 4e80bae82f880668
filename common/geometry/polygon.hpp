/// @file A closed outline, such as the robot's footprint.
#pragma once

#include <vector>

#include "common/geometry/segment.hpp"

namespace perceptor {

/// The sides in order; the last corner joins the first.
std::vector<Segment> edges(const std::vector<Vector2>& polygon);

/// Whether the point lies inside the outline, or within a nanometre of its edge, which makes
/// the edge itself count as inside. The corners go round either way; the last joins the first.
/// Where the outline crosses itself, the even-odd rule decides. Fewer than three corners
/// contain nothing, and nothing contains a point that is not finite.
bool contains(const std::vector<Vector2>& polygon, const Vector2& point);

}  // namespace perceptor
