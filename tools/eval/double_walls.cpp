#include "tools/eval/double_walls.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/time/stamp.hpp"
#include "tools/eval/explained_beams.hpp"

namespace perceptor {
namespace {

/// The wall with free space on the left of a to b.
Segment oriented(const Map& map, const Object& wall) {
  const Segment s = segment(map, wall);
  return wall.free_side == FreeSide::right ? Segment{s.b, s.a} : s;
}

std::vector<Segment> recent_walls(const Map& map, std::int64_t utime, double max_age) {
  std::vector<Segment> walls;
  for (const Object* wall : walls_of(map)) {
    const bool is_recent =
        wall->last_seen != 0 && seconds_between(wall->last_seen, utime) <= max_age;
    if (is_recent && wall->free_side != FreeSide::unknown) walls.push_back(oriented(map, *wall));
  }
  return walls;
}

bool is_double(const Segment& s, const Segment& t, const DoubleWallParameters& parameters) {
  const bool runs_alike = direction(s).dot(direction(t)) > std::cos(parameters.max_angle);
  if (!runs_alike) return false;
  const Segment& longer = length(s) < length(t) ? t : s;
  const Segment& shorter = length(s) < length(t) ? s : t;
  const auto [first, last] = projected_interval(longer, shorter);
  const double from = std::max(first, 0.0);
  const double to = std::min(last, length(longer));
  if (to - from <= parameters.min_overlap) return false;
  const Vector2 inside = longer.a + 0.5 * (from + to) * direction(longer);
  const double apart = std::abs(signed_distance(shorter, inside));
  return apart > 0.0 && apart < parameters.max_distance;
}

}  // namespace

std::size_t count_double_walls(const Map& map, std::int64_t utime,
                               const DoubleWallParameters& parameters) {
  const std::vector<Segment> walls = recent_walls(map, utime, parameters.max_age);
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < walls.size(); ++i)
    for (std::size_t j = i + 1; j < walls.size(); ++j)
      if (is_double(walls[i], walls[j], parameters)) ++pairs;
  return pairs;
}

}  // namespace perceptor
