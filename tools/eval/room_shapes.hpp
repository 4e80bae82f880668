/// @file The outlines that rooms begin with and those of what stands in them.
#pragma once

#include "tools/eval/floor_plan.hpp"
#include "tools/eval/room_random.hpp"

namespace perceptor {

/// From the origin to (width, height) [m], seen from inside.
Outline rectangle(double width, double height);

/// A rectangle of 5 to 9 m that lacks its upper right part, seen from inside.
Outline l_shape(RoomRandom& random);

/// Star-shaped about the origin, 5 to 8 walls, with at least one acute and one obtuse corner;
/// seen from inside.
Outline slanted_outline(RoomRandom& random);

/// About the origin, turned by `angle` [rad], seen from outside.
Outline box(double length, double width, double angle);

/// About the origin, 3 to 6 sides of 0.3 to 1.5 m, seen from outside.
Outline polygon_thing(RoomRandom& random);

/// Moved [m].
Outline moved(Outline outline, const Vector2& by);

}  // namespace perceptor
