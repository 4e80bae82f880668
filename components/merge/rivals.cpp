#include "components/merge/rivals.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/geometry/angle.hpp"

namespace perceptor::merge {
namespace {

/// What the other one leaves of an interval, on the side where it leaves more.
Interval longer_rest(const Interval& interval, const Interval& other) {
  if (common_part(interval, other).length() <= 0.0) return interval;
  const Interval before{interval.from, std::max(interval.from, other.from)};
  const Interval after{std::min(interval.to, other.to), interval.to};
  return before.length() > after.length() ? before : after;
}

/// [m] how far the other, nearly parallel line lies to the left of a place on this one.
double distance_at(const Line& line, double place, const Line& other) {
  return other.normal.dot(other.middle - point_at(line, place)) / other.normal.dot(line.normal);
}

/// A line in whose place another one lies.
struct Overlap {
  Interval piece;         ///< [m] along the line, from its middle
  double distance = 0.0;  ///< [m] of the other one, to the left, in the middle of the piece
};

std::optional<Overlap> overlap(const Line& line, const Line& other,
                               const RivalParameters& parameters) {
  const double reach = (line.length + other.length) / 2.0 + parameters.max_distance;
  if ((other.middle - line.middle).squaredNorm() > reach * reach) return std::nullopt;
  if (line.along.dot(other.along) < std::cos(parameters.max_angle)) return std::nullopt;
  const Interval piece = common_part(extent_of(line), extent_on(line, other));
  if (piece.length() < parameters.min_overlap) return std::nullopt;
  const double distance = distance_at(line, piece.middle(), other);
  if (std::abs(distance) > parameters.max_distance) return std::nullopt;
  return Overlap{piece, distance};
}

/// Between two surfaces that are free on the same side there is a third that is free on the other:
/// what stands in front has a back.
bool has_back(const Line& line, const Overlap& rival, const std::vector<Wall>& walls,
              const RivalParameters& parameters) {
  const Interval& piece = rival.piece;
  const double middle = piece.middle();
  return std::ranges::any_of(walls, [&](const Wall& wall) {
    const Line back = line_of(wall.segment);
    if (line.along.dot(back.along) > -std::cos(parameters.max_angle)) return false;
    const double to_back = std::copysign(1.0, rival.distance) * distance_at(line, middle, back);
    return to_back > parameters.min_thickness &&
           to_back < std::abs(rival.distance) - parameters.min_thickness &&
           common_part(piece, extent_on(line, back)).length() > piece.length() / 2.0;
  });
}

/// The ray from the laser to a point passes through the line, not just past its ends.
bool crosses(const Line& line, const Vector2& laser, const Vector2& point, double margin) {
  const double before = line.normal.dot(laser - line.middle);
  const double behind = line.normal.dot(point - line.middle);
  if (before * behind >= 0.0) return false;
  const Vector2 crossing = laser + before / (before - behind) * (point - laser);
  return std::abs(place_on(line, crossing)) < line.length / 2.0 - margin;
}

bool looks_through(const Line& line, const Vector2& laser, const Segment& part,
                   const RivalParameters& parameters) {
  const double margin = parameters.min_overlap / 2.0;
  return crosses(line, laser, part.a, margin) || crosses(line, laser, part.b, margin);
}

double angle_seen(const Segment& segment, const Vector2& laser) {
  return std::abs(angle_difference(angle(segment.a - laser), angle(segment.b - laser)));
}

/// How many of the scan's beams ended on a part of what it saw: they lie at equal angles.
double beams_on(const Observation& seen, const Segment& part, const Vector2& laser) {
  const double whole = angle_seen(seen.segment, laser);
  return whole > 0.0 ? seen.support * angle_seen(part, laser) / whole : 0.0;
}

/// The part of one line beside a piece of another, nearly parallel one.
Segment beside(const Line& line, const Line& other, const Interval& piece) {
  const Interval part = common_part(extent_of(line), {place_on(line, point_at(other, piece.from)),
                                                      place_on(line, point_at(other, piece.to))});
  return {point_at(line, part.from), point_at(line, part.to)};
}

}  // namespace

std::vector<Contradiction> contradictions(const std::vector<Wall>& walls,
                                          const std::vector<Observation>& seen,
                                          const Vector2& laser, const RivalParameters& parameters) {
  std::vector<Line> lines_seen;
  lines_seen.reserve(seen.size());
  for (const Observation& observation : seen) lines_seen.push_back(line_of(observation.segment));
  const auto index_of = [&walls](std::int32_t id) {
    const auto found = std::ranges::lower_bound(walls, id, {}, &Wall::id);
    return static_cast<std::size_t>(found - walls.begin());
  };

  std::vector<Contradiction> found;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const Line line = line_of(walls[i].segment);
    const auto without_what_is_seen = [&](Interval piece) {
      for (std::size_t k = 0; k < seen.size(); ++k)
        if (seen[k].wall == walls[i].id) piece = longer_rest(piece, extent_on(line, lines_seen[k]));
      return piece;
    };
    for (std::size_t k = 0; k < seen.size(); ++k) {
      if (seen[k].wall == walls[i].id) continue;
      const auto rival = overlap(line, lines_seen[k], parameters);
      if (!rival) continue;
      const Interval piece = without_what_is_seen(rival->piece);
      if (piece.length() < parameters.min_overlap) continue;
      const Segment part = beside(lines_seen[k], line, piece);
      if (beams_on(seen[k], part, laser) < parameters.min_beams) continue;
      if (!looks_through(line, laser, part, parameters) &&
          has_back(line, *rival, walls, parameters))
        continue;
      const double from_tail = line.length / 2.0;
      found.push_back({i, index_of(seen[k].wall), {piece.from + from_tail, piece.to + from_tail}});
    }
  }
  return found;
}

Wall clear_of_rivals(const Wall& sighted, std::size_t known, const std::vector<Wall>& walls,
                     const std::vector<Line>& lines, const RivalParameters& parameters) {
  const Line line = line_of(sighted.segment);
  const Interval whole = extent_of(line);
  const Interval of_known = extent_on(line, lines[known]);
  Interval kept = whole;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    if (i == known || !walls[i].confirmed) continue;
    const auto rival = overlap(line, lines[i], parameters);
    if (!rival || has_back(line, *rival, walls, parameters)) continue;
    const auto [from, to] = rival->piece;
    if (to > of_known.to) kept.to = std::min(kept.to, std::max(of_known.to, from));
    if (from < of_known.from) kept.from = std::max(kept.from, std::min(of_known.from, to));
  }
  Wall clear = sighted;
  if (kept.from > whole.from) clear.ends[kTail].method = CornerMethod::none;
  if (kept.to < whole.to) clear.ends[kHead].method = CornerMethod::none;
  set_ends(clear, {point_at(line, kept.from), point_at(line, kept.to)});
  return clear;
}

Interval free_piece(const Wall& wall, const std::vector<Wall>& walls,
                    const RivalParameters& parameters) {
  const Line line = line_of(wall.segment);
  Interval free = extent_of(line);
  for (const Wall& other : walls) {
    if (!other.confirmed || other.id == wall.id) continue;
    const auto rival = overlap(line, line_of(other.segment), parameters);
    if (rival && !has_back(line, *rival, walls, parameters)) free = longer_rest(free, rival->piece);
  }
  const double from_tail = line.length / 2.0;
  return {free.from + from_tail, free.to + from_tail};
}

}  // namespace perceptor::merge
