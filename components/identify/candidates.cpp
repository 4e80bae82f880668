#include "components/identify/candidates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "components/identify/shut.hpp"

namespace perceptor::identify {
namespace {

/// What can bound an opening, the most certain first.
enum class BoundKind : std::uint8_t { corner, outer_end, turned_end, loose_end, face };

/// An end of a wall that can bound an opening.
struct Bound {
  BoundKind kind = BoundKind::loose_end;
  const Wall* wall = nullptr;
  const WallEnd* end = nullptr;
  Index partner = kNone;  ///< the point that forms the corner with it
};

bool is_convex(BoundKind kind) { return kind == BoundKind::corner || kind == BoundKind::outer_end; }

bool make_door(BoundKind first, BoundKind second) {
  const auto is_jamb = [](BoundKind kind) {
    return is_convex(kind) || kind == BoundKind::turned_end;
  };
  return is_jamb(first) && is_jamb(second) && (is_convex(first) || is_convex(second));
}

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

/// The ends that can bound an opening, by x (and then whatever tells two ends apart), so that
/// those near each other are found without looking at all pairs, and the order of the map's
/// objects does not show.
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

/// For people, by the kinds of the more and the less certain bound.
constexpr std::array<std::array<std::string_view, 5>, 4> kReasons = {{
    {"two convex corners", "convex corner and outer end", "convex corner and turned end",
     "convex corner and loose end", "convex corner faces wall"},
    {"", "two outer ends", "outer end and turned end", "outer end and loose end",
     "outer end faces wall"},
    {"", "", "two turned ends", "turned end and loose end", "turned end faces wall"},
    {"", "", "", "two loose ends", "loose end faces wall"},
}};

std::string_view reason_of(BoundKind first, BoundKind second) {
  const auto [better, worse] = std::minmax(first, second);
  return kReasons.at(static_cast<std::size_t>(better)).at(static_cast<std::size_t>(worse));
}

/// How far an opening is from the best one of its kind, each as a share of its limit.
struct Residuals {
  double angle = 0.0;
  double offset = 0.0;
};

double factor_of(BoundKind kind, const ConfidenceParameters& p) {
  switch (kind) {
    case BoundKind::corner:
      return 1.0;
    case BoundKind::outer_end:
      return p.outer_end;
    case BoundKind::turned_end:
      return p.turned_end;
    case BoundKind::loose_end:
      return p.loose_end;
    case BoundKind::face:
      return p.face;
  }
  return 0.0;
}

/// 0 at the usual width, 1 at the limit on that side of it.
double width_residual(double width, const OpeningParameters& limits, double usual_width) {
  const double limit = width < usual_width ? limits.door_min_width : limits.door_max_width;
  const double allowed = std::abs(limit - usual_width);
  return allowed > 0.0 ? std::min(1.0, std::abs(width - usual_width) / allowed) : 0.0;
}

/// Whether the free side of a wall is left (+1) or right (-1) of a direction; 0: not known.
int side_of(const Vector2& free, const Vector2& along) {
  const double left = cross(along, free);
  return static_cast<int>(left > 0.0) - static_cast<int>(left < 0.0);
}

class CandidateFinder {
 public:
  CandidateFinder(const std::vector<Wall>& walls, const Vector2& robot,
                  const OpeningParameters& limits, const ConfidenceParameters& confidence)
      : walls_(walls), robot_(robot), limits_(limits), confidence_(confidence) {}

  std::optional<Candidate> between(const Bound& first, const Bound& second) const {
    const Vector2 across = second.end->location - first.end->location;
    const bool point_at_each_other =
        first.end->outward.dot(across) > 0.0 && second.end->outward.dot(across) < 0.0;
    if (!point_at_each_other) return std::nullopt;
    const double width = length(across);
    if (!has_door_width(width)) return std::nullopt;
    const Vector2 along = across / width;
    const double angle = std::max(angle_between(first.end->outward, along),
                                  angle_between(second.end->outward, -along));
    if (angle > limits_.max_angle) return std::nullopt;
    const double offset = std::max(std::abs(cross(first.end->outward, across)),
                                   std::abs(cross(second.end->outward, across)));
    if (offset > limits_.max_offset) return std::nullopt;
    const int first_side = side_of(first.wall->free, along);
    const int second_side = side_of(second.wall->free, along);
    const bool face_opposite_ways = first_side * second_side < 0;
    if (face_opposite_ways) return std::nullopt;

    const int side = first_side != 0 ? first_side : second_side;
    const OpeningLine line = opening_line(first.end->location, along, width, side);
    if (is_shut(line, walls_, nullptr, limits_)) return std::nullopt;
    const Residuals residuals{share(angle, limits_.max_angle), share(offset, limits_.max_offset)};
    const bool sides_known = first_side != 0 && second_side != 0;
    Candidate candidate = make(line, first.kind, second.kind, side, sides_known, residuals);
    set_bounds(candidate, line, bound_of(first), bound_of(second));
    candidate.points = {first.end->point, first.partner, second.end->point, second.partner};
    return candidate;
  }

  std::optional<Candidate> onto_face(const Bound& bound, const Wall& face) const {
    if (is_out_of_reach(face, bound.end->location, limits_.door_max_width)) return std::nullopt;
    if (&face == bound.wall) return std::nullopt;
    const Vector2& outward = bound.end->outward;
    const Vector2& face_along = face.ends[1].outward;
    const double off_square = std::abs(outward.dot(face_along));  // sine of the angle
    if (off_square > max_face_sine_) return std::nullopt;
    const Vector2 to_a = face.ends[0].location - bound.end->location;
    const Vector2 to_b = face.ends[1].location - bound.end->location;
    const bool passes_by = cross(outward, to_a) * cross(outward, to_b) >= 0.0;
    if (passes_by) return std::nullopt;
    const double width = cross(to_a, face_along) / cross(outward, face_along);
    if (!has_door_width(width)) return std::nullopt;
    const Vector2 location = bound.end->location + width * outward;
    const double from_face_end = std::min(distance(location, face.ends[0].location),
                                          distance(location, face.ends[1].location));
    if (from_face_end < limits_.end_tolerance) return std::nullopt;
    const double looks_away = face.free.dot(outward);
    if (looks_away > 0.0) return std::nullopt;

    const int side = side_of(bound.wall->free, outward);
    const OpeningLine line = opening_line(bound.end->location, outward, width, side);
    if (is_shut(line, walls_, &face, limits_)) return std::nullopt;
    const Residuals residuals{share(std::asin(off_square), limits_.max_face_angle), 0.0};
    const bool sides_known = side != 0 && looks_away < 0.0;
    Candidate candidate = make(line, bound.kind, BoundKind::face, side, sides_known, residuals);
    set_bounds(candidate, line, bound_of(bound), {location, kNone, face.object});
    candidate.points = {bound.end->point, kNone, kNone, kNone};
    return candidate;
  }

 private:
  bool has_door_width(double width) const {
    return width >= limits_.door_min_width && width <= limits_.door_max_width;
  }

  static double angle_between(const Vector2& u, const Vector2& v) {
    return std::atan2(std::abs(cross(u, v)), u.dot(v));
  }

  static double share(double residual, double limit) {
    return limit > 0.0 ? residual / limit : 0.0;
  }

  static OpeningBound bound_of(const Bound& bound) {
    return {bound.end->location, bound.end->point, bound.wall->object};
  }

  OpeningLine opening_line(const Vector2& start, const Vector2& along, double width,
                           int side) const {
    const bool robot_is_left = cross(along, robot_ - start) >= 0.0;
    const bool is_free_left = side != 0 ? side > 0 : robot_is_left;
    const Vector2 left = perpendicular(along);
    return {.start = start, .along = along, .before = is_free_left ? left : -left, .width = width};
  }

  Candidate make(const OpeningLine& line, BoundKind first, BoundKind second, int side,
                 bool sides_known, const Residuals& residuals) const {
    Candidate candidate;
    Opening& opening = candidate.opening;
    opening.type = make_door(first, second) ? ObjectType::door : ObjectType::possible_door;
    opening.reason = reason_of(first, second);
    opening.free_side = side != 0 ? FreeSide::left : FreeSide::unknown;
    const double fit =
        1.0 - confidence_.angle_share * residuals.angle -
        confidence_.offset_share * residuals.offset -
        confidence_.width_share * width_residual(line.width, limits_, confidence_.usual_width);
    opening.confidence = factor_of(first, confidence_) * factor_of(second, confidence_) *
                         (sides_known ? 1.0 : confidence_.one_side_unknown) * std::max(0.0, fit);
    candidate.width = line.width;
    return candidate;
  }

  /// In the order that has the free side on the left.
  static void set_bounds(Candidate& candidate, const OpeningLine& line, const OpeningBound& first,
                         const OpeningBound& second) {
    const bool is_free_left = cross(line.along, line.before) > 0.0;
    candidate.opening.first = is_free_left ? first : second;
    candidate.opening.second = is_free_left ? second : first;
  }

  const std::vector<Wall>& walls_;
  const Vector2& robot_;
  const OpeningParameters& limits_;
  const ConfidenceParameters& confidence_;
  double max_face_sine_ = std::sin(limits_.max_face_angle);
};

}  // namespace

std::vector<Candidate> find_candidates(const Map& map, const std::vector<Wall>& walls,
                                       const Vector2& robot, const OpeningParameters& parameters,
                                       const ConfidenceParameters& confidence) {
  const CandidateFinder finder(walls, robot, parameters, confidence);
  const std::vector<Bound> bounds = find_bounds(map, walls, parameters);
  std::vector<Candidate> candidates;
  for (auto first = bounds.begin(); first != bounds.end(); ++first) {
    const double x_limit = first->end->location.x() + parameters.door_max_width;
    for (auto second = first + 1; second != bounds.end(); ++second) {
      if (second->end->location.x() > x_limit) break;
      if (auto found = finder.between(*first, *second)) candidates.push_back(*found);
    }
  }
  for (const Bound& bound : bounds) {
    if (bound.kind == BoundKind::corner) continue;
    for (const Wall& wall : walls) {
      if (auto found = finder.onto_face(bound, wall)) candidates.push_back(*found);
    }
  }
  return candidates;
}

}  // namespace perceptor::identify
