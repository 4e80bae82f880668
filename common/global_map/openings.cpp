#include "common/global_map/openings.hpp"

#include <algorithm>
#include <optional>

namespace perceptor::global_map {
namespace {

/// Sideways still counts as ahead, and a little more: the two sides of a corridor seldom end
/// exactly beside each other [of the distance].
constexpr double kBackwards = 0.1;

/// The point of a segment nearest to a place, of those that do not lie behind it.
std::optional<Vector2> nearest_ahead(const Segment& segment, const Vector2& place,
                                     const Vector2& ahead) {
  const double a_ahead = ahead.dot(segment.a - place);
  const double b_ahead = ahead.dot(segment.b - place);
  const Vector2 along = segment.b - segment.a;
  const double fraction = std::clamp(along.dot(place - segment.a) / along.squaredNorm(), 0.0, 1.0);
  const Vector2 nearest = segment.a + fraction * along;
  if (ahead.dot(nearest - place) >= -kBackwards * distance(nearest, place)) return nearest;
  if (std::max(a_ahead, b_ahead) <= 0.0) return std::nullopt;
  // The nearest of those ahead lies where the segment begins to be ahead.
  return Vector2(segment.a + a_ahead / (a_ahead - b_ahead) * along);
}

std::optional<Segment> closing_from(const Arrangement& arrangement, std::size_t half_edge,
                                    double max_opening) {
  const std::size_t vertex = arrangement.target(half_edge);
  const Segment wall = arrangement.segment(half_edge);
  const Vector2 ahead = direction(wall);
  std::optional<Segment> shortest;
  for (std::size_t h = 0; h < arrangement.half_edges(); h += 2) {
    if (arrangement.origin(h) == vertex || arrangement.target(h) == vertex) continue;
    const auto end = nearest_ahead(arrangement.segment(h), wall.b, ahead);
    if (!end || distance(wall.b, *end) > max_opening) continue;
    if (!shortest || distance(wall.b, *end) < length(*shortest)) shortest = Segment{wall.b, *end};
  }
  return shortest;
}

}  // namespace

std::vector<Segment> closings(const Arrangement& arrangement, double max_opening) {
  std::vector<Segment> lines;
  for (std::size_t h = 0; h < arrangement.half_edges(); ++h) {
    const bool is_loose = arrangement.degree(arrangement.target(h)) == 1;
    const bool is_open = arrangement.face(h) == kOutside && arrangement.kind(h).is_solid();
    if (!is_loose || !is_open) continue;
    if (const auto line = closing_from(arrangement, h, max_opening)) lines.push_back(*line);
  }
  return lines;
}

}  // namespace perceptor::global_map
