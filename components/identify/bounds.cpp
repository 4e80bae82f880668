#include "components/identify/bounds.hpp"

#include <algorithm>
#include <optional>
#include <tuple>

namespace perceptor::identify {
namespace {

std::optional<BoundKind> kind_of(const Point& point, bool has_partner) {
  if (point.property == PointProperty::convex) {
    return has_partner ? BoundKind::corner : BoundKind::outer_end;
  }
  if (point.property != PointProperty::floating || has_partner) return std::nullopt;
  const bool was_seen_to_turn =
      point.method == CornerMethod::vector || point.method == CornerMethod::intersection;
  return was_seen_to_turn ? BoundKind::turned_end : BoundKind::loose_end;
}

const Point& point_at(const Map& map, const WallEnd& end) {
  return map.points[static_cast<std::size_t>(end.point)];
}

/// Whether a wall is the depth of another one: shorter than walls are thick, and it goes back
/// from a convex corner. Its far end is the other face's corner, and points across whatever
/// passes by there.
bool is_jamb(const Map& map, const Wall& wall, const WallEnd& far_end, double max_thickness) {
  const WallEnd& near_end = &far_end == wall.ends.data() ? wall.ends[1] : wall.ends[0];
  return wall.length <= max_thickness && near_end.partner.has_value() &&
         point_at(map, near_end).property == PointProperty::convex;
}

}  // namespace

std::vector<Bound> find_bounds(const Map& map, const std::vector<Wall>& walls,
                               const OpeningParameters& parameters) {
  std::vector<Bound> bounds;
  bounds.reserve(2 * walls.size());
  for (const Wall& wall : walls) {
    if (wall.length < parameters.wall_min_length) continue;
    for (const WallEnd& end : wall.ends) {
      const auto kind = kind_of(point_at(map, end), end.partner.has_value());
      if (!kind) continue;
      const bool is_corner = *kind == BoundKind::corner;
      if (!is_corner && is_jamb(map, wall, end, parameters.max_wall_thickness)) continue;
      const Index partner = end.partner ? end_of(walls, *end.partner).point : kNone;
      bounds.push_back({*kind, &wall, &end, partner});
    }
  }
  std::ranges::sort(bounds, {}, [](const Bound& b) {
    return std::tuple(b.end->location.x(), b.end->location.y(), b.end->outward.x(),
                      b.end->outward.y());
  });
  return bounds;
}

}  // namespace perceptor::identify
