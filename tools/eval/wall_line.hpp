/// @file The middle of a wall of a random building.
#pragma once

#include "common/geometry/segment.hpp"

namespace perceptor {

/// The middle of a wall, without end.
struct WallLine {
  Vector2 point = Vector2::Zero();
  Vector2 direction = Vector2::UnitX();
  double thickness = 0.0;  ///< [m]

  /// On the wall's middle, `along` [m] from its point, `aside` [m] to the left.
  Vector2 at(double along, double aside) const {
    return point + along * direction + aside * perpendicular(direction);
  }
  double along(const Vector2& p) const { return (p - point).dot(direction); }
};

}  // namespace perceptor
