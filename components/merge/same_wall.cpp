#include "components/merge/same_wall.hpp"

#include <algorithm>
#include <cmath>

namespace perceptor::merge {
namespace {

double gap_beside(const Line& line, const Interval& other) {
  const double half = line.length / 2.0;
  return std::max({0.0, other.from - half, -half - other.to});
}

double allowed(double floor, double sigmas, double variance, double bound) {
  return std::min(bound, floor + sigmas * std::sqrt(std::max(0.0, variance)));
}

double square(double value) { return value * value; }

bool is_seen_in_full(const Wall& wall) {
  return is_seen_as_end(wall.ends[kTail]) && is_seen_as_end(wall.ends[kHead]);
}

/// Both ends of a short piece lie further on, in the same direction.
bool has_moved_along(const Wall& p, const Line& line_p, const Wall& q,
                     const SameWallParameters& parameters) {
  if (!is_seen_in_full(p) || !is_seen_in_full(q)) return false;
  const double tail_shift = line_p.along.dot(q.segment.a - p.segment.a);
  const double head_shift = line_p.along.dot(q.segment.b - p.segment.b);
  const auto allowed_at = [&](std::size_t end) {
    const double variance = p.ends[end].variance + q.ends[end].variance;
    return parameters.shift + parameters.sigmas * std::sqrt(variance);
  };
  return tail_shift * head_shift > 0.0 && std::abs(tail_shift) > allowed_at(kTail) &&
         std::abs(head_shift) > allowed_at(kHead);
}

/// One of them is known to end before the gap between them: what is behind is another wall, of the
/// next room perhaps.
bool ends_before_gap(const Wall& p, const Line& line_p, const Wall& q, double gap,
                     const SameWallParameters& parameters) {
  const bool q_is_ahead = line_p.along.dot(q.segment.a - p.segment.a) > 0.0;
  const WallEnd& head = (q_is_ahead ? p : q).ends[kHead];
  const WallEnd& tail = (q_is_ahead ? q : p).ends[kTail];
  const double uncertain = parameters.sigmas * std::sqrt(head.variance + tail.variance);
  return (is_known(head) || is_known(tail)) && gap > parameters.shift + uncertain;
}

}  // namespace

std::optional<Difference> compare(const Wall& p, const Line& line_p, const Wall& q,
                                  const Line& line_q, const SameWallParameters& parameters) {
  const bool faces_other_way = line_p.along.dot(line_q.along) <= 0.0;
  if (faces_other_way) return std::nullopt;

  const bool p_is_longer = line_p.length >= line_q.length;
  const Line& longer = p_is_longer ? line_p : line_q;
  const Line& shorter = p_is_longer ? line_q : line_p;

  const double offset = longer.normal.dot(shorter.middle - longer.middle);
  if (std::abs(offset) > parameters.max_offset) return std::nullopt;

  Difference difference;
  const Interval extent = extent_on(longer, shorter);
  difference.gap = gap_beside(longer, extent);
  if (difference.gap > parameters.max_gap) return std::nullopt;
  if (ends_before_gap(p, line_p, q, difference.gap, parameters)) return std::nullopt;

  difference.angle = std::abs(turn_between(longer, shorter));
  const double max_angle = allowed(parameters.angle, parameters.sigmas,
                                   p.covariance(1, 1) + q.covariance(1, 1), parameters.max_angle);
  if (difference.angle > max_angle) return std::nullopt;

  const double slant = std::abs(cross(longer.along, shorter.along)) * shorter.length / 2.0;
  difference.offset = (std::abs(offset + slant) + std::abs(offset - slant)) / 2.0;
  const Eigen::Matrix2d& line_covariance = p_is_longer ? p.covariance : q.covariance;
  const Eigen::Matrix2d& other_covariance = p_is_longer ? q.covariance : p.covariance;
  const double reach = (extent.from + extent.to) / 2.0;
  const double variance = moved_along(line_covariance, reach)(0, 0) + other_covariance(0, 0);
  const double max_offset =
      allowed(parameters.offset, parameters.sigmas, variance, parameters.max_offset);
  if (difference.offset > max_offset) return std::nullopt;
  if (has_moved_along(p, line_p, q, parameters)) return std::nullopt;

  difference.score =
      square(difference.offset / max_offset) + square(difference.angle / max_angle) +
      (difference.gap > 0.0 ? 1.0 + square(difference.gap / parameters.max_gap) : 0.0);
  return difference;
}

std::optional<Segment> gap_between(const Line& p, const Line& q) {
  const Line& longer = p.length >= q.length ? p : q;
  const Line& shorter = p.length >= q.length ? q : p;
  const Interval extent = extent_on(longer, shorter);
  const double half = longer.length / 2.0;
  if (gap_beside(longer, extent) <= 0.0) return std::nullopt;
  const bool is_ahead = extent.from > half;
  const double from = is_ahead ? half : extent.to;
  const double to = is_ahead ? extent.from : -half;
  return Segment{longer.middle + from * longer.along, longer.middle + to * longer.along};
}

}  // namespace perceptor::merge
