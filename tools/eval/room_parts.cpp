#include "tools/eval/room_parts.hpp"

#include <numbers>
#include <utility>

#include "tools/eval/room_shapes.hpp"

namespace perceptor {
namespace {

constexpr int kAttempts = 20;
constexpr double kToCorner = 0.15;  // [m] at least from a part of a wall to the wall's corners

/// `change` says whether there was room for its part at all.
template <class Change>
void add_where_sound(FloorPlan& plan, const Change& change) {
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    FloorPlan changed = plan;
    if (!change(changed) || !is_sound(changed)) continue;
    plan = std::move(changed);
    return;
  }
}

/// Makes a part of any wall stand out, or recede where `depth` is negative.
bool bend_any_wall(RoomRandom& random, Outline& outline, double width, double depth) {
  const auto wall =
      static_cast<std::size_t>(uniform_int(random, 0, static_cast<int>(outline.size()) - 1));
  const double wall_length = distance(outline[wall], outline[(wall + 1) % outline.size()]);
  if (wall_length < width + 2.0 * kToCorner) return false;
  const double begin = uniform(random, kToCorner, wall_length - width - kToCorner);
  const double end = begin + width;
  bend_wall(outline, wall, {{begin, 0.0}, {begin, depth}, {end, depth}, {end, 0.0}});
  return true;
}

/// Puts it anywhere within the bounds of the room.
void place_anywhere(RoomRandom& random, FloorPlan& plan, const Outline& obstacle) {
  const auto [low, high] = bounds(plan);
  const double x = uniform(random, low.x(), high.x());
  const double y = uniform(random, low.y(), high.y());
  plan.outlines.push_back(moved(obstacle, {x, y}));
}

double any_angle(RoomRandom& random) { return uniform(random, 0.0, 2.0 * std::numbers::pi); }

}  // namespace

void bend_wall(Outline& outline, std::size_t wall, const std::vector<Vector2>& path) {
  const Segment side{outline[wall], outline[(wall + 1) % outline.size()]};
  const Vector2 along = direction(side);
  Outline bends;
  for (const Vector2& point : path)
    bends.emplace_back(side.a + point.x() * along + point.y() * perpendicular(along));
  outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(wall) + 1, bends.begin(),
                 bends.end());
}

std::vector<Vector2> path_of(const RoomBehind& room) {
  const double near = -room.thickness;
  const double far = near - room.depth;
  return {{room.door_begin, 0.0}, {room.door_begin, near}, {room.begin, near},
          {room.begin, far},      {room.end, far},         {room.end, near},
          {room.door_end, near},  {room.door_end, 0.0}};
}

void place_door(RoomRandom& random, RoomBehind& room) {
  const double width = uniform(random, 0.7, 1.2);
  room.door_begin = uniform(random, room.begin + kToCorner, room.end - kToCorner - width);
  room.door_end = room.door_begin + width;
}

double wall_thickness(RoomRandom& random) { return uniform(random, 0.1, 0.2); }

void add_exit(RoomRandom& random, FloorPlan& plan) {
  add_where_sound(plan, [&](FloorPlan& changed) {
    const double width = uniform(random, 0.7, 1.4);
    const double corridor_length = uniform(random, 1.5, 5.0);
    return bend_any_wall(random, changed.outlines.front(), width, -corridor_length);
  });
}

void add_room_behind(RoomRandom& random, FloorPlan& plan) {
  add_where_sound(plan, [&](FloorPlan& changed) {
    Outline& outline = changed.outlines.front();
    const auto wall =
        static_cast<std::size_t>(uniform_int(random, 0, static_cast<int>(outline.size()) - 1));
    const double wall_length = distance(outline[wall], outline[(wall + 1) % outline.size()]);
    if (wall_length < 1.6) return false;
    RoomBehind room;
    room.end = wall_length;
    place_door(random, room);
    room.begin = room.door_begin - uniform(random, kToCorner, 2.0);
    room.end = room.door_end + uniform(random, kToCorner, 2.0);
    room.thickness = wall_thickness(random);
    room.depth = uniform(random, 1.5, 4.0);
    bend_wall(outline, wall, path_of(room));
    return true;
  });
}

void add_recess(RoomRandom& random, FloorPlan& plan) {
  add_where_sound(plan, [&](FloorPlan& changed) {
    const double width = uniform(random, 0.3, 1.5);
    const double depth = uniform(random, 0.1, 0.3);
    const bool is_niche = happens(random, 0.7);
    return bend_any_wall(random, changed.outlines.front(), width, is_niche ? -depth : depth);
  });
}

void add_partition(RoomRandom& random, FloorPlan& plan) {
  add_where_sound(plan, [&](FloorPlan& changed) {
    const double thickness = uniform(random, 0.05, 0.15);
    const double depth = uniform(random, 0.8, 2.5);
    return bend_any_wall(random, changed.outlines.front(), thickness, depth);
  });
}

void add_free_partition(RoomRandom& random, FloorPlan& plan) {
  add_where_sound(plan, [&](FloorPlan& changed) {
    const double thickness = uniform(random, 0.05, 0.15);
    const double partition_length = uniform(random, 0.8, 2.5);
    place_anywhere(random, changed, box(partition_length, thickness, any_angle(random)));
    return true;
  });
}

void add_cabinet(RoomRandom& random, FloorPlan& plan) {
  add_where_sound(plan, [&](FloorPlan& changed) {
    const double width = uniform(random, 0.3, 1.5);
    const double depth = uniform(random, 0.3, 1.5);
    return bend_any_wall(random, changed.outlines.front(), width, depth);
  });
}

void add_box(RoomRandom& random, FloorPlan& plan) {
  add_where_sound(plan, [&](FloorPlan& changed) {
    const double box_length = uniform(random, 0.3, 1.5);
    const double width = uniform(random, 0.3, 1.5);
    const bool is_turned = happens(random, 0.5);
    place_anywhere(random, changed, box(box_length, width, is_turned ? any_angle(random) : 0.0));
    return true;
  });
}

void add_polygon(RoomRandom& random, FloorPlan& plan) {
  add_where_sound(plan, [&](FloorPlan& changed) {
    place_anywhere(random, changed, polygon_thing(random));
    return true;
  });
}

}  // namespace perceptor
