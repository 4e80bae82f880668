#include "common/geometry/polygon.hpp"

#include <cmath>
#include <cstddef>

namespace perceptor {
namespace {

/// [m] Rounding moves a point that was computed to lie on the edge by less than this.
constexpr double kEdgeWidth = 1e-9;

/// Whether the ray from the point towards +x crosses the side. A side owns its lower end
/// only, so that a ray through a corner is counted once.
bool ray_crosses(const Segment& side, const Vector2& point) {
  const bool a_is_above = side.a.y() > point.y();
  const bool b_is_above = side.b.y() > point.y();
  if (a_is_above == b_is_above) return false;
  const double fraction = (point.y() - side.a.y()) / (side.b.y() - side.a.y());
  return point.x() < side.a.x() + fraction * (side.b.x() - side.a.x());
}

/// Far from the polygon, where most points are.
bool is_beside(const std::vector<Vector2>& polygon, const Vector2& point) {
  Vector2 low = polygon.front();
  Vector2 high = polygon.front();
  for (const Vector2& corner : polygon) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  constexpr double margin = 2.0 * kEdgeWidth;
  return ((point - high).array() > margin).any() || ((low - point).array() > margin).any();
}

}  // namespace

std::vector<Segment> edges(const std::vector<Vector2>& polygon) {
  std::vector<Segment> edges;
  edges.reserve(polygon.size());
  for (std::size_t i = 0; i < polygon.size(); ++i)
    edges.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
  return edges;
}

bool contains(const std::vector<Vector2>& polygon, const Vector2& point) {
  if (polygon.size() < 3 || !point.allFinite()) return false;
  if (is_beside(polygon, point)) return false;
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Segment side{polygon[i], polygon[(i + 1) % polygon.size()]};
    if (distance(side, point) <= kEdgeWidth) return true;
    if (ray_crosses(side, point)) inside = !inside;
  }
  return inside;
}

}  // namespace perceptor
