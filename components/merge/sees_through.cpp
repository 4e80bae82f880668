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

/// A wall as the laser looks at it: along it, and away from it on the side where the laser is
/// not.
struct View {
  Vector2 tail = Vector2::Zero();
  Vector2 along = Vector2::Zero();
  double length = 0.0;       ///< [m]
  double laser_along = 0.0;  ///< [m] from the tail
  double laser_away = 0.0;   ///< [m] at least 0
  double side = 1.0;         ///< +1: the laser is on the left

  double depth_of(const Vector2& point) const { return -side * cross(along, point - tail); }
  double along_of(const Vector2& point) const { return along.dot(point - tail) - laser_along; }
};

View view_of(const Segment& screen, const Vector2& laser) {
  View view;
  view.tail = screen.a;
  view.along = direction(screen);
  view.length = length(screen);
  view.laser_along = view.along.dot(laser - screen.a);
  const double left = cross(view.along, laser - screen.a);
  view.laser_away = std::abs(left);
  view.side = left > 0.0 ? 1.0 : -1.0;
  return view;
}

std::optional<Interval> passed_through(const View& view, const Segment& target,
                                       const SeesThroughParameters& parameters) {
  if (view.laser_away < parameters.min_distance) return std::nullopt;
  const double depth_a = view.depth_of(target.a);
  const double depth_b = view.depth_of(target.b);
  Part part;
  clip(part, depth_a - parameters.behind, depth_b - parameters.behind);
  if (part.is_empty()) return std::nullopt;

  // A point is behind the screen where its ray from the laser is between those to the ends of
  // the screen: linear in the point, once multiplied by its distance from the laser's line.
  const double margin = std::min(parameters.end_margin, view.length / 4.0);
  const double along_a = view.along_of(target.a);
  const double along_b = view.along_of(target.b);
  const double first = margin - view.laser_along;
  const double last = view.length - margin - view.laser_along;
  const double reach_a = (depth_a + view.laser_away) / view.laser_away;
  const double reach_b = (depth_b + view.laser_away) / view.laser_away;
  clip(part, along_a - first * reach_a, along_b - first * reach_b);
  clip(part, last * reach_a - along_a, last * reach_b - along_b);
  if (part.is_empty()) return std::nullopt;

  const auto passes_at = [&](double fraction) {
    const double target_along = along_a + fraction * (along_b - along_a);
    const double reach = reach_a + fraction * (reach_b - reach_a);
    return view.laser_along + target_along / reach;
  };
  const auto [from, to] = std::minmax({passes_at(part.from), passes_at(part.to)});
  const double min_width = std::min(parameters.min_width, view.length / 2.0 - margin);
  if (to - from < min_width) return std::nullopt;
  return Interval{from, to};
}

}  // namespace

std::optional<Interval> passed_through(const Segment& screen, const Vector2& laser,
                                       const Segment& target,
                                       const SeesThroughParameters& parameters) {
  return passed_through(view_of(screen, laser), target, parameters);
}

std::optional<Interval> widest_opening(const Segment& screen, const Vector2& laser,
                                       const std::vector<Wall>& targets,
                                       const SeesThroughParameters& parameters) {
  const View view = view_of(screen, laser);
  std::vector<Interval> pieces;
  for (const Wall& target : targets)
    if (const auto piece = passed_through(view, target.segment, parameters))
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
