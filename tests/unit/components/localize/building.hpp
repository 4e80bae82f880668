/// @file Small buildings, and what a robot in them sees.
#pragma once

#include <cstdint>
#include <vector>

#include "common/global_map/global_map.hpp"
#include "components/localize/localizer.hpp"
#include "tests/support/scene.hpp"

namespace perceptor::localize {

/// A room, its corners counter-clockwise: free inside. Both as a map and as what a laser meets.
struct Building {
  explicit Building(const std::vector<Vector2>& corners) : scene(test::room(corners)) {
    for (const Segment& wall : scene) {
      const Index index = add_segment(map, wall, ObjectType::wall);
      map.objects[static_cast<std::size_t>(index)].free_side = FreeSide::left;
    }
  }

  Map map;
  test::Scene scene;
};

/// No place of it looks like another.
inline Building angled_room() {
  return Building({{0.0, 0.0}, {5.0, 0.0}, {5.0, 2.0}, {3.0, 2.0}, {3.0, 4.0}, {0.0, 4.0}});
}

/// Looks the same from both ends.
inline Building plain_room() { return Building({{0.0, 0.0}, {4.0, 0.0}, {4.0, 3.0}, {0.0, 3.0}}); }

/// All walls of the building in a frame, seen at `utime`.
inline Map walls_in(const Building& building, const Position& frame_in_world, std::int64_t utime) {
  Map walls = transform(building.map, inverse(frame_in_world));
  for (Object& wall : walls.objects) {
    wall.last_seen = utime;
    wall.line_covariance = Eigen::Vector2d(1e-6, 1e-6).asDiagonal();
  }
  for (Point& end : walls.points) {
    end.method = CornerMethod::intersection;
    end.covariance = 1e-6 * Eigen::Matrix2d::Identity();
  }
  return walls;
}

/// `scene` is what the laser meets: the building and what stands in it.
inline Sight sight(const Building& building, const test::Scene& scene,
                   const Position& robot_in_world, const Position& robot_in_local,
                   std::int64_t utime) {
  Sight sight;
  sight.utime = utime;
  sight.robot_in_local = robot_in_local;
  sight.walls = walls_in(building, robot_in_world, utime);
  sight.scan_walls = sight.walls;
  sight.ends = beam_ends(test::sweep(scene, test::pico_laser(0.01), robot_in_world));
  return sight;
}

}  // namespace perceptor::localize
