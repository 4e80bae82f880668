#include "tools/eval/corner_score.hpp"

#include <cmath>
#include <optional>

namespace perceptor {
namespace {

bool is_seen(const TrueCorner& corner, const SeenSides& seen) {
  for (const std::size_t side : corner.sides)
    for (const FreeSide from : {FreeSide::left, FreeSide::right})
      if (side < seen.size() && seen.seen(side, from).since != 0) return true;
  return false;
}

const TrueCorner* nearest_corner(const Vector2& location, const TrueWorld& world,
                                 const SeenSides& seen, double max_offset) {
  const TrueCorner* nearest = nullptr;
  for (const TrueCorner& corner : world.corners) {
    const double offset = distance(location, corner.location);
    if (offset >= max_offset || !is_seen(corner, seen)) continue;
    max_offset = offset;
    nearest = &corner;
  }
  return nearest;
}

/// Concave where one side stands in the space that the other is seen from.
std::optional<PointProperty> true_type(const TrueCorner& corner, const TrueWorld& world,
                                       const SeenSides& seen) {
  for (std::size_t i = 0; i < 2; ++i) {
    const Segment& side = world.sides[corner.sides[i]].segment;
    const Segment& other = world.sides[corner.sides[1 - i]].segment;
    const FreeSide from = seen.seen_from(corner.sides[i]);
    if (from == FreeSide::unknown) continue;
    const Vector2 free = perpendicular(direction(side)) * static_cast<double>(from);
    const bool begins = distance(other.a, corner.location) < distance(other.b, corner.location);
    const Vector2 away = begins ? direction(other) : Vector2(-direction(other));
    return free.dot(away) > 0.0 ? PointProperty::concave : PointProperty::convex;
  }
  return std::nullopt;
}

}  // namespace

double CornerScore::rms() const {
  return right.part > 0 ? std::sqrt(squared_error / static_cast<double>(right.part)) : 0.0;
}

std::vector<WrongCorner> score_corners(const Map& map, const TrueWorld& world,
                                       const SeenSides& seen,
                                       const CornerScoreParameters& parameters,
                                       CornerScore& score) {
  std::vector<WrongCorner> wrong;
  for (std::size_t i = 0; i < map.points.size(); ++i) {
    const Point& point = map.points[i];
    const bool is_typed =
        point.property == PointProperty::convex || point.property == PointProperty::concave;
    // Each of the two ends names the other: the first one counts.
    if (!is_typed || point.connected <= static_cast<Index>(i)) continue;
    const Point& partner = map.points[static_cast<std::size_t>(point.connected)];
    const Vector2 location = 0.5 * (point.location + partner.location);
    const TrueCorner* corner = nearest_corner(location, world, seen, parameters.max_offset);
    score.right += {corner != nullptr ? 1 : 0, 1};
    if (corner == nullptr) {
      wrong.push_back({location, CornerFault::none_there});
      continue;
    }
    score.squared_error += (location - corner->location).squaredNorm();
    const auto type = true_type(*corner, world, seen);
    if (!type) continue;
    score.confused += {*type != point.property ? 1 : 0, 1};
    if (*type != point.property) wrong.push_back({location, CornerFault::wrong_type});
  }
  return wrong;
}

}  // namespace perceptor
