#include "components/identify/corner_types.hpp"

#include <cmath>
#include <numbers>

namespace perceptor::identify {
namespace {

/// One of the two walls that meet at a corner.
struct Leg {
  Vector2 away;  ///< length one, along the wall, away from the corner
  Vector2 free;  ///< normal on the free side; zero: unknown
};

struct Corner {
  Vector2 location;
  Leg first;
  Leg second;
};

/// +1 convex, -1 concave, 0 not known.
int vote_of(const Leg& leg, const Leg& other) {
  const double towards_other = leg.free.dot(other.away);
  if (towards_other == 0.0) return 0;
  return towards_other < 0.0 ? 1 : -1;
}

bool is_between_walls(const Vector2& place, const Corner& corner) {
  const Vector2 from_corner = place - corner.location;
  const double turn = cross(corner.first.away, corner.second.away);
  return cross(corner.first.away, from_corner) * turn > 0.0 &&
         cross(from_corner, corner.second.away) * turn > 0.0;
}

PointProperty type_of(const Corner& corner, const Vector2& robot, double straight_angle) {
  const auto& [location, first, second] = corner;
  const double between_walls =
      std::atan2(std::abs(cross(first.away, second.away)), first.away.dot(second.away));
  const bool goes_straight_on = between_walls > std::numbers::pi - straight_angle;
  if (goes_straight_on) return PointProperty::connected;
  const bool folds_back = between_walls < straight_angle;
  if (folds_back) {
    const bool free_on_both_faces = first.free.dot(second.free) < 0.0;
    return free_on_both_faces ? PointProperty::convex : PointProperty::connected;
  }

  const int votes = vote_of(first, second) + vote_of(second, first);
  if (votes > 0) return PointProperty::convex;
  if (votes < 0) return PointProperty::concave;
  return is_between_walls(robot, corner) ? PointProperty::concave : PointProperty::convex;
}

bool is_nearer_side_of_jump(const Point& point, const CornerTypeParameters& parameters) {
  return parameters.jump_is_convex && point.method == CornerMethod::spike;
}

PointProperty type_of_loose_end(const Point& point, const CornerTypeParameters& parameters) {
  if (is_nearer_side_of_jump(point, parameters)) return PointProperty::convex;
  const bool lost_its_partner = point.property == PointProperty::connected;
  return lost_its_partner ? PointProperty::floating : point.property;
}

Corner corner_of(const Wall& wall, const WallEnd& end, const EndHandle& partner,
                 const std::vector<Wall>& walls) {
  const Wall& other_wall = walls[partner.wall];
  const WallEnd& other = end_of(walls, partner);
  return {.location = 0.5 * (end.location + other.location),
          .first = {-end.outward, wall.free},
          .second = {-other.outward, other_wall.free}};
}

}  // namespace

void classify_corners(Map& map, const std::vector<Wall>& walls, const Vector2& robot,
                      const CornerTypeParameters& parameters) {
  for (const Wall& wall : walls) {
    for (const WallEnd& end : wall.ends) {
      Point& point = map.points[static_cast<std::size_t>(end.point)];
      point.property = end.partner ? type_of(corner_of(wall, end, *end.partner, walls), robot,
                                             parameters.straight_angle)
                                   : type_of_loose_end(point, parameters);
    }
  }
  for (Point& point : map.points) {
    const bool is_lone_corner = point.parents.empty();
    if (is_lone_corner && is_nearer_side_of_jump(point, parameters)) {
      point.property = PointProperty::convex;
    }
  }
}

}  // namespace perceptor::identify
