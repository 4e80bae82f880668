#include "components/merge/rivals.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/geometry/angle.hpp"

namespace perceptor::merge {
namespace {

double length_of(const Interval& interval) { return interval.to - interval.from; }

Interval intersection(const Interval& p, const Interval& q) {
  return {std::max(p.from, q.from), std::min(p.to, q.to)};
}

/// What the other one leaves of an interval, on the side where it leaves more.
Interval longer_rest(const Interval& interval, const Interval& other) {
  if (length_of(intersection(interval, other)) <= 0.0) return interval;
  const Interval before{interval.from, std::max(interval.from, other.from)};
  const Interval after{std::min(interval.to, other.to), interval.to};
  return length_of(before) > length_of(after) ? before : after;
}

/// [m] along a line, from its middle.
double place_on(const Line& line, const Vector2& point) {
  return line.along.dot(point - line.middle);
}

Vector2 point_at(const Line& line, double place) { return line.middle + place * line.along; }

Interval extent_on(const Line& line, const Line& other) {
  const double centre = place_on(line, other.middle);
  const double half = std::abs(line.along.dot(other.along)) * other.length / 2.0;
  return {centre - half, centre + half};
}

Interval extent_of(const Line& line) { return {-line.length / 2.0, line.length / 2.0}; }

/// The piece of `line` in whose place the other one lies.
std::optional<Interval> common_piece(const Line& line, const Line& other,
                                     const RivalParameters& parameters) {
  const double reach = (line.length + other.length) / 2.0 + parameters.max_distance;
  if ((other.middle - line.middle).squaredNorm() > reach * reach) return std::nullopt;
  if (line.along.dot(other.along) < std::cos(parameters.max_angle)) return std::nullopt;
  const Interval piece = intersection(extent_of(line), extent_on(line, other));
  if (length_of(piece) < parameters.min_overlap) return std::nullopt;
  const Vector2 middle = point_at(line, (piece.from + piece.to) / 2.0);
  if (std::abs(other.normal.dot(middle - other.middle)) > parameters.max_distance)
    return std::nullopt;
  return piece;
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
  const Interval part = intersection(extent_of(line), {place_on(line, point_at(other, piece.from)),
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
      const auto common = common_piece(line, lines_seen[k], parameters);
      if (!common) continue;
      const Interval piece = without_what_is_seen(*common);
      if (length_of(piece) < parameters.min_overlap) continue;
      const Segment part = beside(lines_seen[k], line, piece);
      if (beams_on(seen[k], part, laser) < parameters.min_beams) continue;
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
    const auto piece = common_piece(line, lines[i], parameters);
    if (!piece) continue;
    if (piece->to > of_known.to) kept.to = std::min(kept.to, std::max(of_known.to, piece->from));
    if (piece->from < of_known.from)
      kept.from = std::max(kept.from, std::min(of_known.from, piece->to));
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
    const auto piece = common_piece(line, line_of(other.segment), parameters);
    if (piece) free = longer_rest(free, *piece);
  }
  const double from_tail = line.length / 2.0;
  return {free.from + from_tail, free.to + from_tail};
}

}  // namespace perceptor::merge
