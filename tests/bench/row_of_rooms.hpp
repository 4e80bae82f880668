/// @file A map with as many walls as one likes.
#pragma once

#include <array>

#include "common/model/map.hpp"

namespace perceptor {

/// Five walls each 5 m, seen from below: a front with a doorway of 1 m, and a recess 2 m deep.
/// Walls come as scan gives them: with covariances, free side left.
///
///    +-------+           +-------+
///    |       |           |       |
///   -+       +---     ---+       +---     --
inline Map row_of_rooms(int walls) {
  const std::array<Segment, 5> piece = {{{{0, 0}, {-1, 0}},
                                         {{-2, 0}, {-3, 0}},
                                         {{-3, 0}, {-3, 2}},
                                         {{-3, 2}, {-5, 2}},
                                         {{-5, 2}, {-5, 0}}}};
  Map map;
  for (int i = 0; i < walls; ++i) {
    const Vector2 place(-5.0 * (i / 5), 0.0);
    const Segment& drawn = piece.at(static_cast<std::size_t>(i) % piece.size());
    const Index index = add_segment(map, {place + drawn.a, place + drawn.b}, ObjectType::wall);
    Object& object = map.objects[static_cast<std::size_t>(index)];
    object.id = index;
    object.free_side = FreeSide::left;
    object.support = 40;
    object.weight = 1.0;
    object.line_covariance = 1e-6 * Eigen::Matrix2d::Identity();
    for (const Index point : object.points) {
      map.points[static_cast<std::size_t>(point)].covariance = 1e-4 * Eigen::Matrix2d::Identity();
      map.points[static_cast<std::size_t>(point)].radius = 0.2;
    }
  }
  return map;
}

}  // namespace perceptor
