#include "components/bridge/sim/shapes.hpp"

#include <algorithm>

namespace perceptor::sim {

Polygon outline(const Box& box) {
  const double x = box.length / 2.0;
  const double y = box.width / 2.0;
  return transform(box.box_in_world, Polygon{{x, y}, {-x, y}, {-x, -y}, {x, -y}});
}

Polygon transform(const Position& b_in_a, const Polygon& polygon_in_b) {
  Polygon result;
  result.reserve(polygon_in_b.size());
  for (const Vector2& corner : polygon_in_b) result.push_back(perceptor::transform(b_in_a, corner));
  return result;
}

double radius_of(const Polygon& polygon) {
  double radius = 0.0;
  for (const Vector2& corner : polygon) radius = std::max(radius, corner.norm());
  return radius;
}

bool cross_each_other(const Segment& s, const Segment& t) {
  const Vector2 along_s = s.b - s.a;
  const Vector2 along_t = t.b - t.a;
  const double denominator = cross(along_s, along_t);
  if (denominator == 0.0) return false;
  const double on_s = cross(t.a - s.a, along_t) / denominator;
  const double on_t = cross(t.a - s.a, along_s) / denominator;
  return on_s >= 0.0 && on_s <= 1.0 && on_t >= 0.0 && on_t <= 1.0;
}

bool touches(const Polygon& polygon, const Segment& segment) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Segment edge{polygon[i], polygon[(i + 1) % polygon.size()]};
    if (cross_each_other(edge, segment)) return true;
  }
  return contains(polygon, segment.a);
}

bool touches(const Polygon& polygon, const Circle& circle) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Segment edge{polygon[i], polygon[(i + 1) % polygon.size()]};
    if (distance(edge, circle.centre) <= circle.radius) return true;
  }
  return contains(polygon, circle.centre);
}

}  // namespace perceptor::sim
