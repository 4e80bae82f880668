#include "components/identify/entrance.hpp"

#include <algorithm>

#include "common/geometry/angle.hpp"
#include "common/time/stamp.hpp"
#include "components/identify/crossing.hpp"

namespace perceptor::identify {
namespace {

/// A door or a possible door; the free side is left of the way from a to b.
struct Passage {
  Segment line;
  double confidence = 0.0;
  bool is_door = false;
  std::int64_t last_seen = 0;  ///< [us] when both walls were; 0: unknown
};

std::vector<Passage> passages_of(const Map& map) {
  std::vector<Passage> passages;
  for (const Object& object : map.objects) {
    const bool is_door = object.type == ObjectType::door;
    const bool is_passage = is_door || object.type == ObjectType::possible_door;
    if (!is_passage || object.points.size() != 2) continue;
    passages.push_back({segment(map, object), object.confidence, is_door, object.last_seen});
  }
  return passages;
}

Exit exit_through(const Passage& door) {
  const Vector2 outward = -perpendicular(direction(door.line));
  return {middle(door.line), angle(outward), length(door.line), door.confidence};
}

bool is_seen_lately(const Passage& door, std::int64_t utime, const EntranceParameters& parameters) {
  const bool is_unknown = door.last_seen == 0;
  return is_unknown || seconds_between(door.last_seen, utime) <= parameters.max_unseen;
}

bool is_seen(const Segment& sight, const std::vector<Wall>& walls) {
  return std::ranges::none_of(
      walls, [&](const Wall& wall) { return cross_each_other(sight, segment_of(wall)); });
}

}  // namespace

Exit transform(const Position& b_in_a, const Exit& exit_in_b) {
  Exit exit = exit_in_b;
  exit.middle = transform(b_in_a, exit_in_b.middle);
  exit.direction = wrap_angle(b_in_a.a + exit_in_b.direction);
  return exit;
}

std::vector<Exit> find_exits(const Map& map, const std::vector<Wall>& walls, const Vector2& robot,
                             std::int64_t utime, const EntranceParameters& parameters) {
  const std::vector<Passage> passages = passages_of(map);
  std::vector<Exit> exits;
  for (const Passage& door : passages) {
    if (!door.is_door || !is_seen_lately(door, utime, parameters)) continue;
    const Segment sight{robot, middle(door.line)};
    if (length(sight) > parameters.max_distance) continue;
    const bool is_before = signed_distance(door.line, robot) > 0.0;
    if (!is_before) continue;
    const bool lies_behind_another = std::ranges::any_of(passages, [&](const Passage& other) {
      return &other != &door && cross_each_other(sight, other.line);
    });
    if (lies_behind_another || !is_seen(sight, walls)) continue;
    exits.push_back(exit_through(door));
  }
  return exits;
}

}  // namespace perceptor::identify
