#include "common/floorplan/outline.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace perceptor {
namespace {

bool is_same(const Vector2& p, const Vector2& q) { return distance(p, q) <= kSameCorner; }

/// Takes out the side that goes on at a place, and gives its other end.
std::optional<Vector2> take_side_at(const Vector2& place, std::vector<Segment>& sides) {
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const auto [a, b] = sides[i];
    if (!is_same(a, place) && !is_same(b, place)) continue;
    sides.erase(sides.begin() + static_cast<std::ptrdiff_t>(i));
    return is_same(a, place) ? b : a;
  }
  return std::nullopt;
}

void extend(std::vector<Vector2>& line, std::vector<Segment>& sides) {
  while (const auto next = take_side_at(line.back(), sides)) line.push_back(*next);
}

}  // namespace

std::optional<std::vector<Vector2>> find_corners(const Floorplan& plan,
                                                 const std::vector<Floorplan::Edge>& outline) {
  std::vector<Segment> sides;
  sides.reserve(outline.size());
  for (const Floorplan::Edge& edge : outline) sides.push_back(plan.segment(edge));
  const Segment front = sides.front();
  sides.erase(sides.begin());

  std::vector<Vector2> line = {front.a, front.b};
  extend(line, sides);
  const bool closes = line.size() > 3 && is_same(line.back(), line.front());
  if (closes) {
    line.pop_back();
  } else {
    // The side that closes the outline is not drawn: the sides go on before the front, too.
    std::vector<Vector2> before = {front.a};
    extend(before, sides);
    line.insert(line.end(), before.rbegin(), before.rend() - 1);
  }
  if (!sides.empty()) return std::nullopt;
  for (std::size_t i = 0; i < line.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (is_same(line[i], line[j])) return std::nullopt;
  return line;
}

std::vector<Vector2> corners(const Floorplan& plan, const std::vector<Floorplan::Edge>& outline) {
  return find_corners(plan, outline).value();
}

Segment opening(const Floorplan& plan, const std::vector<Floorplan::Edge>& door) {
  return plan.segment(std::ranges::max(
      door, {}, [&](const Floorplan::Edge& edge) { return length(plan.segment(edge)); }));
}

}  // namespace perceptor
