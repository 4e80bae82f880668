#include "tools/eval/floor_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/geometry/angle.hpp"
#include "common/geometry/polygon.hpp"

namespace perceptor {
namespace {

/// How far the direction turns from one wall to the next [rad]: to the left positive.
double turn(const Segment& wall, const Segment& next) {
  return angle_difference(angle(wall), angle(next));
}

bool is_corner(const Segment& wall, const Segment& next, const PlanLimits& limits) {
  const double turned = std::abs(turn(wall, next));
  return turned >= limits.min_turn && turned <= std::numbers::pi - limits.sharpest_corner;
}

bool keep_apart(const std::vector<PlanWall>& walls, const PlanLimits& limits) {
  for (std::size_t i = 0; i < walls.size(); ++i)
    for (std::size_t j = i + 1; j < walls.size(); ++j) {
      const bool are_neighbours =
          walls[i].next == static_cast<int>(j) || walls[j].next == static_cast<int>(i);
      const double smallest_gap =
          walls[i].outline == walls[j].outline ? limits.min_gap : limits.min_passage;
      if (!are_neighbours && distance(walls[i].segment, walls[j].segment) < smallest_gap)
        return false;
    }
  return true;
}

/// Of outlines that do not cross: whether each obstacle's first corner lies within the first
/// outline and within no other obstacle.
bool obstacles_stand_free(const FloorPlan& plan) {
  for (std::size_t i = 1; i < plan.outlines.size(); ++i) {
    const Vector2& corner = plan.outlines[i].front();
    for (std::size_t j = 0; j < plan.outlines.size(); ++j)
      if (j != i && contains(plan.outlines[j], corner) != (j == 0)) return false;
  }
  return true;
}

}  // namespace

std::vector<PlanWall> walls(const FloorPlan& plan) {
  std::vector<PlanWall> walls;
  for (std::size_t number = 0; number < plan.outlines.size(); ++number) {
    const Outline& outline = plan.outlines[number];
    const std::size_t first = walls.size();
    const std::size_t sides = outline.size();
    const auto side = [&](std::size_t i) {
      return Segment{outline[i % sides], outline[(i + 1) % sides]};
    };
    for (std::size_t i = 0; i < sides; ++i)
      walls.push_back({.segment = side(i),
                       .next = static_cast<int>(first + (i + 1) % sides),
                       .ends_in_convex = turn(side(i), side(i + 1)) < 0.0,
                       .outline = number});
  }
  return walls;
}

std::pair<Vector2, Vector2> bounds(const FloorPlan& plan) {
  Vector2 low = plan.outlines.front().front();
  Vector2 high = low;
  for (const Vector2& corner : plan.outlines.front()) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  return {low, high};
}

bool is_free(const FloorPlan& plan, const Vector2& point) {
  if (plan.outlines.empty() || !contains(plan.outlines.front(), point)) return false;
  return std::none_of(plan.outlines.begin() + 1, plan.outlines.end(),
                      [&](const Outline& obstacle) { return contains(obstacle, point); });
}

double clearance(const std::vector<PlanWall>& walls, const Vector2& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const PlanWall& wall : walls) nearest = std::min(nearest, distance(wall.segment, point));
  return nearest;
}

bool is_sound(const FloorPlan& plan, const PlanLimits& limits) {
  const std::vector<PlanWall> all = walls(plan);
  const bool has_good_corners = std::ranges::all_of(all, [&](const PlanWall& wall) {
    const Segment& next = all[static_cast<std::size_t>(wall.next)].segment;
    return length(wall.segment) >= limits.min_side && is_corner(wall.segment, next, limits);
  });
  return has_good_corners && keep_apart(all, limits) && obstacles_stand_free(plan);
}

}  // namespace perceptor
