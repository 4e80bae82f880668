#include "components/identify/candidates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "components/identify/bounds.hpp"
#include "components/identify/shut.hpp"

namespace perceptor::identify {
namespace {

bool make_door(BoundKind first, BoundKind second) {
  const auto is_jamb = [](BoundKind kind) {
    return is_convex(kind) || kind == BoundKind::turned_end;
  };
  return is_jamb(first) && is_jamb(second);
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

constexpr std::string_view kJambsReason = "facing jambs that end";

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

  /// Of two walls in about one line.
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

  /// Of a doorway that is seen from within: its walls are hidden, its jambs face each other.
  std::optional<Candidate> between_jambs(const Bound& first, const Bound& second) const {
    const bool lie_in_walls = first.kind == BoundKind::corner && second.kind == BoundKind::corner;
    const bool are_a_corridor =
        std::min(first.wall->length, second.wall->length) > limits_.max_jamb_length;
    if (lie_in_walls || are_a_corridor || !is_convex(first.kind) || !is_convex(second.kind))
      return std::nullopt;
    if (first.end->outward.dot(second.end->outward) < max_angle_cosine_) return std::nullopt;
    const Vector2 across = second.end->location - first.end->location;
    const double width = length(across);
    if (!has_door_width(width)) return std::nullopt;
    const double first_faces = first.wall->free.dot(across);
    const double second_faces = -second.wall->free.dot(across);
    const bool look_away = first_faces < 0.0 || second_faces < 0.0;
    if (look_away) return std::nullopt;
    const Vector2 along = across / width;
    const int side_within = -side_of(first.end->outward, along);
    const Vector2 outward = -side_within * perpendicular(along);
    const double angle = std::max(angle_between(first.end->outward, outward),
                                  angle_between(second.end->outward, outward));
    if (angle > limits_.max_face_angle) return std::nullopt;

    const OpeningLine line = opening_line(first.end->location, along, width, side_within);
    if (is_shut(line, walls_, nullptr, limits_)) return std::nullopt;
    const Residuals residuals{share(angle, limits_.max_face_angle), 0.0};
    const bool sides_known = first_faces > 0.0 && second_faces > 0.0;
    Candidate candidate = make(line, first.kind, second.kind, side_within, sides_known, residuals);
    candidate.opening.reason = kJambsReason;
    set_bounds(candidate, line, bound_of(first), bound_of(second));
    candidate.points = {first.end->point, first.partner, second.end->point, second.partner};
    return candidate;
  }

  /// Of a wall's end and the wall that it looks at.
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
  double max_angle_cosine_ = std::cos(limits_.max_angle);
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
      if (auto found = finder.between_jambs(*first, *second)) candidates.push_back(*found);
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
