#include "components/merge/sees_through.hpp"

#include <algorithm>
#include <cmath>

namespace perceptor::merge {
namespace {

/// Part of a segment, as fractions from its first end.
struct Part {
  double from = 0.0;
  double to = 1.0;

  bool is_empty() const { return from >= to; }
};

/// Keeps the part where a value that is linear along the segment is not negative.
void clip(Part& part, double at_start, double at_end) {
  if (at_start < 0.0 && at_end < 0.0) {
    part.to = part.from;
  } else if (at_start < 0.0) {
    part.from = std::max(part.from, at_start / (at_start - at_end));
  } else if (at_end < 0.0) {
    part.to = std::min(part.to, at_start / (at_start - at_end));
  }
}

}  // namespace

std::optional<Interval> passed_through(const Segment& screen, const Vector2& laser,
                                       const Segment& target,
                                       const SeesThroughParameters& parameters) {
  // Seen from the screen's tail: along it, and away from it on the side where the laser is not.
  const Vector2 along = direction(screen);
  const Vector2 to_laser = laser - screen.a;
  const double laser_along = along.dot(to_laser);
  const double laser_left = cross(along, to_laser);
  const double laser_away = std::abs(laser_left);
  if (laser_away < parameters.min_distance) return std::nullopt;
  const double side = laser_left > 0.0 ? 1.0 : -1.0;
  const auto depth_of = [&](const Vector2& p) { return -side * cross(along, p - screen.a); };
  const double depth_a = depth_of(target.a);
  const double depth_b = depth_of(target.b);
  Part part;
  clip(part, depth_a - parameters.behind, depth_b - parameters.behind);
  if (part.is_empty()) return std::nullopt;

  // A point is behind the screen where its ray from the laser is between those to the ends of
  // the screen: linear in the point, once multiplied by its distance from the laser's line.
  const double screen_length = length(screen);
  const double margin = std::min(parameters.end_margin, screen_length / 4.0);
  const double along_a = along.dot(target.a - screen.a) - laser_along;
  const double along_b = along.dot(target.b - screen.a) - laser_along;
  const double first = margin - laser_along;
  const double last = screen_length - margin - laser_along;
  const double reach_a = (depth_a + laser_away) / laser_away;
  const double reach_b = (depth_b + laser_away) / laser_away;
  clip(part, along_a - first * reach_a, along_b - first * reach_b);
  clip(part, last * reach_a - along_a, last * reach_b - along_b);
  if (part.is_empty()) return std::nullopt;

  const auto passes_at = [&](double fraction) {
    const double target_along = along_a + fraction * (along_b - along_a);
    const double reach = reach_a + fraction * (reach_b - reach_a);
    return laser_along + target_along / reach;
  };
  const auto [from, to] = std::minmax({passes_at(part.from), passes_at(part.to)});
  if (to - from < std::min(parameters.min_width, screen_length / 2.0 - margin)) return std::nullopt;
  return Interval{from, to};
}

std::optional<Interval> widest_opening(const Segment& screen, const Vector2& laser,
                                       const std::vector<Wall>& targets,
                                       const SeesThroughParameters& parameters) {
  std::vector<Interval> pieces;
  for (const Wall& target : targets)
    if (const auto piece = passed_through(screen, laser, target.segment, parameters))
      pieces.push_back(*piece);
  if (pieces.empty()) return std::nullopt;
  std::sort(pieces.begin(), pieces.end(), [](const Interval& p, const Interval& q) {
    return p.from < q.from || (p.from == q.from && p.to < q.to);
  });
  Interval widest = pieces.front();
  Interval joined = pieces.front();
  for (const Interval& piece : pieces) {
    if (piece.from > joined.to) joined = piece;
    joined.to = std::max(joined.to, piece.to);
    if (joined.to - joined.from > widest.to - widest.from) widest = joined;
  }
  return widest;
}

}  // namespace perceptor::merge
