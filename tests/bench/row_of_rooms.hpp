/// @file A map with as many walls as one likes.
#pragma once

#include "common/model/map.hpp"

namespace perceptor {

/// A row of square recesses of 2 m with doorways of 1 m between them, each wall seen from the
/// south. Walls come as scan gives them: with covariances, free side left.
///
///      +---+     +---+     +
///      |   |     |   |     |
///   ---+   +-----+   +-----+
inline Map row_of_rooms(int walls) {
  Map map;
  double x = 0.0;
  for (int i = 0; i < walls; ++i) {
    const bool is_front = i % 4 == 0;
    const bool is_back = i % 4 == 2;
    const Vector2 a(x, i % 4 <= 1 ? 0.0 : 2.0);
    const Vector2 b = is_front || is_back ? Vector2(x - 2.0, a.y()) : Vector2(x, 2.0 - a.y());
    if (is_front || is_back) x -= is_front ? 2.0 : 3.0;
    const Index index = add_segment(map, {a, b}, ObjectType::wall, "wall");
    Object& object = map.objects[static_cast<std::size_t>(index)];
    object.id = index;
    object.free_side = FreeSide::left;
    object.support = 40;
    object.weight = 1.0;
    object.line_covariance = Eigen::Matrix2d(Eigen::Vector2d(1e-6, 1e-6).asDiagonal());
    for (const Index point : object.points) {
      map.points[static_cast<std::size_t>(point)].covariance = 1e-4 * Eigen::Matrix2d::Identity();
      map.points[static_cast<std::size_t>(point)].radius = 0.2;
    }
  }
  return map;
}

}  // namespace perceptor
