/// @file Walls of a map, as a test draws them.
#pragma once

#include "common/model/map.hpp"

namespace perceptor::testing {

/// A wall from a to b that was seen from its left.
inline Object& add_wall(Map& map, const Segment& segment, std::int64_t last_seen = 1) {
  const Index index = add_segment(map, segment, ObjectType::wall);
  Object& wall = map.objects[static_cast<std::size_t>(index)];
  wall.free_side = FreeSide::left;
  wall.last_seen = last_seen;
  return wall;
}

}  // namespace perceptor::testing
