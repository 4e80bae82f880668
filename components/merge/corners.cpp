#include "components/merge/corners.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>

namespace perceptor::merge {
namespace {

double square(double value) { return value * value; }

struct Corner {
  std::size_t arriving = 0;  ///< the wall whose head it is
  std::size_t leaving = 0;   ///< the wall whose tail it is
  Vector2 location = Vector2::Zero();
  bool is_intersection = false;
  bool was_connected = false;
  double spread = 0.0;  ///< [m] between the ends before
};

Vector2 intersection(const Vector2& on_p, const Vector2& along_p, const Vector2& on_q,
                     const Vector2& along_q) {
  return on_p + cross(on_q - on_p, along_q) / cross(along_p, along_q) * along_p;
}

Vector2 weighted_middle(const Vector2& head, double head_variance, const Vector2& tail,
                        double tail_variance) {
  return (head * tail_variance + tail * head_variance) / (head_variance + tail_variance);
}

bool were_connected(const Wall& arriving, const Wall& leaving) {
  return arriving.ends[kHead].connected == leaving.id &&
         leaving.ends[kTail].connected == arriving.id;
}

/// How far from an end its corner may lie.
double reach_of(const WallEnd& end, bool was_connected, const CornerParameters& parameters,
                const EndParameters& ends) {
  const double radius = was_connected ? parameters.keep_radius : end.radius;
  return is_seen_as_end(end) ? std::min(radius, reach_of_seen(end, ends)) : radius;
}

/// The corner that two walls would form, if they may.
std::optional<Corner> possible_corner(const Wall& arriving, const Wall& leaving,
                                      const CornerParameters& parameters,
                                      const EndParameters& ends) {
  const Vector2& head = arriving.segment.b;
  const Vector2& tail = leaving.segment.a;
  const WallEnd& head_end = arriving.ends[kHead];
  const WallEnd& tail_end = leaving.ends[kTail];

  const Vector2 along_in = direction(arriving.segment);
  const Vector2 along_out = direction(leaving.segment);
  const double turn = std::abs(std::atan2(cross(along_in, along_out), along_in.dot(along_out)));
  const bool are_opposite_faces = turn > std::numbers::pi - parameters.min_angle;
  if (are_opposite_faces) return std::nullopt;

  Corner corner;
  corner.was_connected = were_connected(arriving, leaving);
  corner.is_intersection = turn >= parameters.min_angle;
  corner.spread = distance(head, tail);
  const bool is_step = std::abs(cross(along_in, tail - head)) > parameters.max_step;
  const bool is_apart = corner.spread > parameters.max_hole;
  if (!corner.is_intersection && (is_step || is_apart)) return std::nullopt;
  corner.location = corner.is_intersection
                        ? intersection(head, along_in, tail, along_out)
                        : weighted_middle(head, head_end.variance, tail, tail_end.variance);

  const double head_reach = reach_of(head_end, corner.was_connected, parameters, ends);
  const double tail_reach = reach_of(tail_end, corner.was_connected, parameters, ends);
  const bool is_within_radius = distance(corner.location, head) <= head_reach &&
                                distance(corner.location, tail) <= tail_reach;
  const bool keeps_both = along_in.dot(corner.location - arriving.segment.a) > 0.0 &&
                          along_out.dot(leaving.segment.b - corner.location) > 0.0;
  if (!is_within_radius || !keeps_both) return std::nullopt;
  return corner;
}

std::vector<Corner> possible_corners(const std::vector<Wall>& walls,
                                     const CornerParameters& parameters,
                                     const EndParameters& ends) {
  std::vector<Corner> corners;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    for (std::size_t j = 0; j < walls.size(); ++j) {
      const double reach = std::max(2.0 * parameters.keep_radius,
                                    walls[i].ends[kHead].radius + walls[j].ends[kTail].radius);
      const Vector2 apart = walls[j].segment.a - walls[i].segment.b;
      if (i == j || apart.squaredNorm() > square(reach)) continue;
      if (auto corner = possible_corner(walls[i], walls[j], parameters, ends)) {
        corner->arriving = i;
        corner->leaving = j;
        corners.push_back(*corner);
      }
    }
  }
  return corners;
}

bool comes_before(const Corner& p, const Corner& q) {
  const auto key = [](const Corner& c) {
    return std::tuple(!c.was_connected, c.spread, c.arriving, c.leaving);
  };
  return key(p) < key(q);
}

/// How well the line of `other` fixes a place along `wall`.
double variance_by_line(const Wall& wall, const Wall& other) {
  const double sine = cross(direction(wall.segment), direction(other.segment));
  const double to_end = length(other.segment) / 2.0;
  return (other.covariance(0, 0) + other.covariance(1, 1) * square(to_end)) / square(sine);
}

void fix_end(WallEnd& end, std::int32_t partner, double variance, bool is_intersection,
             const EndParameters& parameters) {
  end.connected = partner;
  end.overshoots = 0;
  if (!is_intersection) return;
  if (!is_known(end)) end.method = CornerMethod::intersection;
  sharpen(end, variance, parameters);
}

void apply(const Corner& corner, std::vector<Wall>& walls, const EndParameters& parameters) {
  Wall& arriving = walls[corner.arriving];
  Wall& leaving = walls[corner.leaving];
  set_ends(arriving, {arriving.segment.a, corner.location});
  set_ends(leaving, {corner.location, leaving.segment.b});
  const double along_arriving = corner.is_intersection ? variance_by_line(arriving, leaving) : 0.0;
  const double along_leaving = corner.is_intersection ? variance_by_line(leaving, arriving) : 0.0;
  fix_end(arriving.ends[kHead], leaving.id, along_arriving, corner.is_intersection, parameters);
  fix_end(leaving.ends[kTail], arriving.id, along_leaving, corner.is_intersection, parameters);
}

}  // namespace

void connect_corners(std::vector<Wall>& walls, const CornerParameters& parameters,
                     const EndParameters& ends) {
  std::vector<Corner> corners = possible_corners(walls, parameters, ends);
  std::sort(corners.begin(), corners.end(), comes_before);
  for (Wall& wall : walls)
    for (WallEnd& end : wall.ends) end.connected = kNone;
  for (const Corner& corner : corners) {
    const bool is_taken = walls[corner.arriving].ends[kHead].connected != kNone ||
                          walls[corner.leaving].ends[kTail].connected != kNone;
    if (!is_taken) apply(corner, walls, ends);
  }
  // An end that was known only by the wall that it met is loose again without it.
  for (Wall& wall : walls)
    for (WallEnd& end : wall.ends)
      if (end.connected == kNone && end.method == CornerMethod::intersection)
        end.method = CornerMethod::none;
}

}  // namespace perceptor::merge
