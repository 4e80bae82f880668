#include "components/localize/start_hint.hpp"

#include <algorithm>
#include <cmath>

#include "common/geometry/angle.hpp"
#include "common/geometry/polygon.hpp"

namespace perceptor::localize {

bool allows(const StartHint& hint, const Position& robot_in_world) {
  const Vector2 place = robot_in_world.location();
  if (hint.pose)
    return distance(place, hint.pose->location()) <= hint.distance &&
           std::abs(angle_difference(robot_in_world.a, hint.pose->a)) <= hint.angle;
  const auto is_close = [&](const Segment& side) { return distance(side, place) <= hint.distance; };
  return std::ranges::any_of(hint.areas, [&](const std::vector<Vector2>& area) {
    return contains(area, place) || std::ranges::any_of(edges(area), is_close);
  });
}

}  // namespace perceptor::localize
