/// @file Angles in radians, counter-clockwise positive.
#pragma once

namespace perceptor {

/// The same direction in (-pi, pi]; both +pi and -pi give +pi. NaN stays NaN.
double wrap_angle(double angle);

/// From `from` to `to` the short way round, in (-pi, pi].
double angle_difference(double from, double to);

}  // namespace perceptor
