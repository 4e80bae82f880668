/// @file The walls of a map as identify looks at them: where each end is, which way it points,
/// which other end it meets, and on which side the wall is free.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "common/model/map.hpp"

namespace perceptor::identify {

/// Names one end of one wall in a list of walls.
struct EndHandle {
  std::size_t wall = 0;
  std::size_t end = 0;  ///< 0 or 1
};

/// One end of a wall.
struct WallEnd {
  Index point = kNone;                 ///< in Map::points
  Vector2 location = Vector2::Zero();  ///< [m]
  Vector2 outward = Vector2::Zero();   ///< length one, along the wall, out of it
  std::optional<EndHandle> partner;    ///< end of another wall that it forms a corner with
};

/// A wall of two ends and some length.
struct Wall {
  Index object = kNone;              ///< in Map::objects
  double length = 0.0;               ///< [m]
  Vector2 middle = Vector2::Zero();  ///< [m]
  Vector2 free = Vector2::Zero();    ///< normal on the free side, length one; zero: unknown
  std::array<WallEnd, 2> ends;       ///< in the order of the object's points
};

/// All walls of a map that can be looked at: of type wall, with two different points that are
/// there, and with a finite length that is not zero. Others say nothing of corners or doors,
/// and an end that is connected to anything else has no partner.
std::vector<Wall> read_walls(const Map& map);

/// Whether a place is so far from all of a wall, ends included, that nothing within `reach`
/// [m] of the place can touch it. Quick, and never wrong; false says nothing.
inline bool is_out_of_reach(const Wall& wall, const Vector2& place, double reach) {
  const double limit = 0.5 * wall.length + reach;
  return (wall.middle - place).squaredNorm() > limit * limit;
}

inline Segment segment_of(const Wall& wall) {
  return {wall.ends[0].location, wall.ends[1].location};
}

inline const WallEnd& end_of(const std::vector<Wall>& walls, const EndHandle& handle) {
  return walls[handle.wall].ends[handle.end];
}

}  // namespace perceptor::identify
