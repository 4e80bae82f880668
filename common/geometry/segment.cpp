#include "common/geometry/segment.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace perceptor {
namespace {

/// A measure of two segments that the longer one gives the line for. Of two that are equally
/// long neither comes first: the larger value holds.
template <class Measure>
double with_longer_first(const Segment& s, const Segment& t, Measure measure) {
  const double s_length = length(s);
  const double t_length = length(t);
  if (s_length > t_length) return measure(s, t);
  if (t_length > s_length) return measure(t, s);
  return std::max(measure(s, t), measure(t, s));
}

double gap_along(const Segment& line, const Segment& other) {
  if (length(line) == 0.0) return distance(line.a, other.a);
  const auto [first, last] = projected_interval(line, other);
  return std::max({0.0, first - length(line), -last});
}

}  // namespace

double angle(const Segment& s) { return angle(Vector2(s.b - s.a)); }

double length(const Segment& s) { return distance(s.a, s.b); }

Vector2 middle(const Segment& s) { return 0.5 * (s.a + s.b); }

Vector2 direction(const Segment& s) { return unit(s.b - s.a); }

double smallest_relative_angle(const Segment& s, const Segment& t) {
  const Vector2 u = direction(s);
  const Vector2 v = direction(t);
  return std::atan2(std::abs(cross(u, v)), std::abs(u.dot(v)));
}

double angle_between(const Segment& s, const Segment& t) {
  constexpr double full_turn = 2.0 * std::numbers::pi;
  const Vector2 u = direction(s);
  const Vector2 v = direction(t);
  const double turn = angle(Vector2(u.dot(v), cross(u, v)));
  const double positive_turn = turn < 0.0 ? turn + full_turn : turn;
  return positive_turn < full_turn ? positive_turn : 0.0;
}

double signed_distance(const Segment& s, const Vector2& point) {
  if (length(s) == 0.0) return distance(s.a, point);
  return cross(direction(s), point - s.a);
}

double average_perpendicular_distance(const Segment& s, const Segment& t) {
  return 0.5 * (std::abs(signed_distance(s, t.a)) + std::abs(signed_distance(s, t.b)));
}

double mutual_perpendicular_distance(const Segment& s, const Segment& t) {
  return with_longer_first(s, t, average_perpendicular_distance);
}

double gap_distance(const Segment& s, const Segment& t) {
  return with_longer_first(s, t, gap_along);
}

std::array<double, 2> projected_interval(const Segment& s, const Segment& t) {
  const Vector2 along = direction(s);
  const double a = along.dot(t.a - s.a);
  const double b = along.dot(t.b - s.a);
  return {std::min(a, b), std::max(a, b)};
}

double distance(const Segment& s, const Vector2& point) {
  const Vector2 along = direction(s);
  const double nearest = std::clamp(along.dot(point - s.a), 0.0, length(s));
  return distance(Vector2(s.a + nearest * along), point);
}

double distance(const Segment& s, const Segment& t) {
  const auto parts = [](const Segment& line, const Segment& other) {
    return signed_distance(line, other.a) * signed_distance(line, other.b) < 0.0;
  };
  if (parts(s, t) && parts(t, s)) return 0.0;
  return std::min({distance(s, t.a), distance(s, t.b), distance(t, s.a), distance(t, s.b)});
}

Segment transform(const Position& b_in_a, const Segment& segment_in_b) {
  return {transform(b_in_a, segment_in_b.a), transform(b_in_a, segment_in_b.b)};
}

}  // namespace perceptor
