/// @file Drawn scenes. Walls run with the free space on their left, so the outline of a solid
/// is drawn clockwise, and a room counter-clockwise.
#pragma once

#include <initializer_list>
#include <vector>

#include "components/identify/identify.hpp"

namespace perceptor::identify::test {

inline const Vector2 kRobot = Vector2::Zero();

/// Walls from each place to the next, connected into corners; gives the walls.
inline std::vector<Index> draw(Map& map, std::initializer_list<Vector2> places,
                               FreeSide free_side = FreeSide::left) {
  std::vector<Index> walls;
  for (const auto* place = places.begin(); place + 1 != places.end(); ++place) {
    const Index wall = add_segment(map, {*place, *(place + 1)}, ObjectType::wall);
    Object& object = map.objects[static_cast<std::size_t>(wall)];
    object.free_side = free_side;
    if (!walls.empty()) {
      const Object& before = map.objects[static_cast<std::size_t>(walls.back())];
      connect(map, before.points[1], object.points[0]);
    }
    walls.push_back(wall);
  }
  return walls;
}

/// The same, and the last wall meets the first.
inline std::vector<Index> draw_ring(Map& map, std::initializer_list<Vector2> places,
                                    FreeSide free_side = FreeSide::left) {
  std::vector<Index> walls = draw(map, places, free_side);
  const Index closing = add_segment(map, {*(places.end() - 1), *places.begin()}, ObjectType::wall);
  Object& object = map.objects[static_cast<std::size_t>(closing)];
  object.free_side = free_side;
  connect(map, map.objects[static_cast<std::size_t>(walls.back())].points[1], object.points[0]);
  connect(map, object.points[1], map.objects[static_cast<std::size_t>(walls.front())].points[0]);
  walls.push_back(closing);
  return walls;
}

inline Point& end_point(Map& map, Index wall, std::size_t end) {
  const Object& object = map.objects[static_cast<std::size_t>(wall)];
  return map.points[static_cast<std::size_t>(object.points[end])];
}

/// Two walls along y = 2, free towards the robot, with jambs 0.2 m deep, and an opening of
/// `width` around x = 0:
///
///   jamb |        | jamb        ^ y
///   -----+        +-----        |
///             R                 +---> x
inline Map doorway(double width) {
  Map map;
  const double x = 0.5 * width;
  draw(map, {{3, 2}, {x, 2}, {x, 2.2}});
  draw(map, {{-x, 2.2}, {-x, 2}, {-3, 2}});
  return map;
}

/// A room of 6 x 4 m around the robot, with a doorway of 0.9 m in its upper wall, y = 2.
inline Map room_with_doorway() {
  Map map;
  draw(map, {{-0.45, 2.2}, {-0.45, 2}, {-3, 2}, {-3, -2}, {3, -2}, {3, 2}, {0.45, 2}, {0.45, 2.2}});
  return map;
}

/// Two loose walls along y = 2, free towards the robot, with `width` between them around x = 0:
/// the right one is drawn first, and ends at its head; the left one begins at its tail.
inline Map loose_walls(double width) {
  Map map;
  draw(map, {{3, 2}, {0.5 * width, 2}});
  draw(map, {{-0.5 * width, 2}, {-3, 2}});
  return map;
}

inline std::vector<Opening> openings_of(Map map, const Vector2& robot = kRobot,
                                        const IdentifyParameters& parameters = {}) {
  const std::vector<Wall> walls = read_walls(map);
  classify_corners(map, walls, robot, parameters.corners);
  return find_openings(map, walls, robot, parameters.openings, parameters.confidence);
}

inline double width_of(const Opening& opening) {
  return distance(opening.first.location, opening.second.location);
}

inline Vector2 middle_of(const Opening& opening) {
  return 0.5 * (opening.first.location + opening.second.location);
}

}  // namespace perceptor::identify::test
