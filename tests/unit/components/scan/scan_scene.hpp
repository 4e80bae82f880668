/// @file What the tests of scan look at maps with.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "components/scan/current_map.hpp"
#include "tests/support/scene.hpp"

namespace perceptor::test {

inline constexpr double kDegree = std::numbers::pi / 180.0;

inline Map map_of(const LaserScan& scan, const Twist& twist = {},
                  const scan::ScanParameters& parameters = {}) {
  scan::WallExtractor extractor(parameters);
  return scan::current_map(extractor.extract(scan, twist), parameters.corner);
}

inline std::vector<Segment> walls_of(const Map& map) {
  std::vector<Segment> walls;
  for (const Object& object : map.objects) walls.push_back(segment(map, object));
  return walls;
}

/// Ends that lie on each other, to the given distance.
inline bool is_near(const Segment& wall, const Segment& expected, double tolerance) {
  return distance(wall.a, expected.a) <= tolerance && distance(wall.b, expected.b) <= tolerance;
}

inline bool has_wall(const std::vector<Segment>& walls, const Segment& expected, double tolerance) {
  return std::ranges::any_of(
      walls, [&](const Segment& wall) { return is_near(wall, expected, tolerance); });
}

/// A room of 4 m by 3 m around the origin, counter-clockwise.
inline std::vector<Vector2> room_corners() { return {{-2, -1.5}, {2, -1.5}, {2, 1.5}, {-2, 1.5}}; }

inline bool shows_the_room(const Map& map, const Position& robot_in_world, double tolerance) {
  const std::vector<Segment> walls = walls_of(map);
  if (walls.size() != 4) return false;
  return std::ranges::all_of(room(room_corners()), [&](const Segment& piece) {
    return has_wall(walls, transform(inverse(robot_in_world), piece), tolerance);
  });
}

/// Ends, and lone corners, that were seen by a method.
inline std::vector<Vector2> seen_by(const Map& map, CornerMethod method, bool lone) {
  std::vector<Vector2> found;
  for (const Point& point : map.points)
    if (point.method == method && point.parents.empty() == lone) found.push_back(point.location);
  return found;
}

}  // namespace perceptor::test
