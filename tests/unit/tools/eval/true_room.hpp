/// @file A small world for tests of the score of maps: two rooms, a doorway in the thick wall
/// between them, as SIM_WORLD tells it.
///
///     (0,3)-----------+ +-----------(8.2,3)
///       |             | |             |
///       |             +-+ (4,2)       |
///       |                             |
///       |             +-+ (4,1)       |
///       |             | |             |
///     (0,0)-----------+ +-----------(8.2,0)
#pragma once

#include <array>

#include "common/model/map.hpp"
#include "tools/eval/true_world.hpp"

namespace perceptor::testing {

/// Sides of the left room, in their order in the world.
enum LeftRoom : std::size_t { kBelow, kRightLower, kRightUpper, kAbove, kLeft };

inline Object& add_object(Map& map, const Segment& segment, ObjectType type, int id,
                          const char* reason = "") {
  const Index index = add_segment(map, segment, type);
  Object& object = map.objects[static_cast<std::size_t>(index)];
  object.id = id;
  object.reason = reason;
  return object;
}

inline Map two_rooms(const char* door_state = "open") {
  const std::array walls = {Segment{{0.0, 0.0}, {4.0, 0.0}}, Segment{{4.0, 0.0}, {4.0, 1.0}},
                            Segment{{4.0, 2.0}, {4.0, 3.0}}, Segment{{4.0, 3.0}, {0.0, 3.0}},
                            Segment{{0.0, 3.0}, {0.0, 0.0}}, Segment{{4.2, 0.0}, {8.2, 0.0}},
                            Segment{{8.2, 0.0}, {8.2, 3.0}}, Segment{{8.2, 3.0}, {4.2, 3.0}},
                            Segment{{4.2, 3.0}, {4.2, 2.0}}, Segment{{4.2, 1.0}, {4.2, 0.0}},
                            Segment{{4.0, 1.0}, {4.2, 1.0}}, Segment{{4.0, 2.0}, {4.2, 2.0}}};
  Map map;
  int id = 0;
  for (const Segment& wall : walls) add_object(map, wall, ObjectType::wall, id++);
  add_object(map, {{4.0, 1.0}, {4.0, 2.0}}, ObjectType::door, id++, door_state);
  return map;
}

inline TrueWorld true_rooms(const Map& map = two_rooms()) { return true_world(map, {}); }

/// A turn of beams, one each half degree.
inline constexpr std::size_t kBeams = 721;
inline constexpr double kTurn = 6.283185307179586;

}  // namespace perceptor::testing
