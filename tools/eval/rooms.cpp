#include "tools/eval/rooms.hpp"

#include <numbers>
#include <stdexcept>

#include "tools/eval/room_parts.hpp"
#include "tools/eval/room_shapes.hpp"

namespace perceptor {
namespace {

using Part = void (*)(RoomRandom&, FloorPlan&);

void add_some(RoomRandom& random, FloorPlan& plan, Part add, int fewest, int most) {
  const int parts = uniform_int(random, fewest, most);
  for (int i = 0; i < parts; ++i) add(random, plan);
}

FloorPlan plain_room(RoomRandom& random) {
  const double width = uniform(random, 3.0, 8.0);
  const double height = uniform(random, 3.0, 7.0);
  return {{rectangle(width, height)}};
}

FloorPlan escape_room(RoomRandom& random) {
  FloorPlan plan = plain_room(random);
  add_exit(random, plan);
  return plan;
}

FloorPlan l_shaped_room(RoomRandom& random) {
  FloorPlan plan{{l_shape(random)}};
  add_room_behind(random, plan);
  add_some(random, plan, add_box, 0, 2);
  return plan;
}

/// The rooms along one side of a corridor, one after the other.
std::vector<Vector2> row_of_rooms(RoomRandom& random, double corridor_length, double thickness) {
  std::vector<Vector2> path;
  double begin = uniform(random, 0.0, 1.5);
  while (true) {
    RoomBehind room{.begin = begin, .end = begin + uniform(random, 2.0, 5.0)};
    if (room.end > corridor_length) return path;
    place_door(random, room);
    room.thickness = thickness;
    room.depth = uniform(random, 2.0, 5.0);
    const std::vector<Vector2> bends = path_of(room);
    path.insert(path.end(), bends.begin(), bends.end());
    begin = room.end + thickness;
  }
}

FloorPlan corridor_with_rooms(RoomRandom& random) {
  constexpr std::size_t kLowerSide = 0;
  constexpr std::size_t kUpperSide = 2;
  const double corridor_length = uniform(random, 8.0, 15.0);
  const double width = uniform(random, 1.2, 2.5);
  const double thickness = wall_thickness(random);
  FloorPlan plan{{rectangle(corridor_length, width)}};
  Outline& outline = plan.outlines.front();
  bend_wall(outline, kUpperSide, row_of_rooms(random, corridor_length, thickness));
  bend_wall(outline, kLowerSide, row_of_rooms(random, corridor_length, thickness));
  add_some(random, plan, add_cabinet, 0, 3);
  add_some(random, plan, add_box, 0, 3);
  return plan;
}

FloorPlan slanted_room(RoomRandom& random) {
  FloorPlan plan{{slanted_outline(random)}};
  add_some(random, plan, add_polygon, 0, 2);
  add_some(random, plan, add_box, 0, 1);
  return plan;
}

FloorPlan cluttered_room(RoomRandom& random) {
  FloorPlan plan = plain_room(random);
  add_some(random, plan, add_cabinet, 1, 4);
  add_some(random, plan, add_box, 1, 4);
  add_some(random, plan, add_polygon, 0, 3);
  return plan;
}

FloorPlan partitioned_room(RoomRandom& random) {
  FloorPlan plan = plain_room(random);
  add_some(random, plan, add_partition, 1, 3);
  add_some(random, plan, add_free_partition, 1, 2);
  return plan;
}

FloorPlan recessed_room(RoomRandom& random) {
  FloorPlan plan = plain_room(random);
  add_some(random, plan, add_recess, 3, 7);
  return plan;
}

}  // namespace

FloorPlan make_room(RoomKind kind, RoomRandom& random) {
  switch (kind) {
    case RoomKind::escape:
      return escape_room(random);
    case RoomKind::l_shape:
      return l_shaped_room(random);
    case RoomKind::corridor:
      return corridor_with_rooms(random);
    case RoomKind::slanted:
      return slanted_room(random);
    case RoomKind::cluttered:
      return cluttered_room(random);
    case RoomKind::partitioned:
      return partitioned_room(random);
    case RoomKind::recessed:
      return recessed_room(random);
  }
  throw std::invalid_argument("make_room: no such kind of room");
}

Position free_pose(const FloorPlan& plan, RoomRandom& random, double min_clearance) {
  constexpr int kAttempts = 100'000;  // a place that takes up a thousandth of the bounds is found
  const std::vector<PlanWall> all = walls(plan);
  const auto [low, high] = bounds(plan);
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const double x = uniform(random, low.x(), high.x());
    const double y = uniform(random, low.y(), high.y());
    if (!is_free(plan, {x, y}) || clearance(all, {x, y}) < min_clearance) continue;
    return {x, y, uniform(random, -std::numbers::pi, std::numbers::pi)};
  }
  throw std::runtime_error("free_pose: no place that far from the walls");
}

}  // namespace perceptor
