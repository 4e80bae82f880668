#include "components/bridge/sim/base.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "components/bridge/velocity_command.hpp"

namespace perceptor::sim {
namespace {

/// At most `limit` long, in the same direction.
Vector2 limited(const Vector2& v, double limit) {
  const double size = v.norm();
  return size > limit ? Vector2(v * (limit / size)) : v;
}

/// What stands within `reach` of a place: the rest cannot be touched in this step.
Obstacles near(const Obstacles& all, const Vector2& place, double reach) {
  Obstacles result;
  for (const Segment& segment : all.segments)
    if (distance(segment, place) <= reach) result.segments.push_back(segment);
  for (const Circle& body : all.bodies)
    if (distance(body.centre, place) <= reach + body.radius) result.bodies.push_back(body);
  return result;
}

/// The direction along the surface of what a footprint touches; none: it touches nothing.
std::optional<Vector2> touched_surface(const Polygon& footprint, const Vector2& centre,
                                       const Obstacles& obstacles) {
  for (const Segment& segment : obstacles.segments)
    if (touches(footprint, segment)) return direction(segment);
  for (const Circle& body : obstacles.bodies)
    if (touches(footprint, body)) return perpendicular(unit(body.centre - centre));
  return std::nullopt;
}

bool is_still(const Twist& twist) { return twist.vx == 0.0 && twist.vy == 0.0 && twist.va == 0.0; }

}  // namespace

Base::Base(const BaseParameters& parameters, const Position& robot_in_world)
    : parameters_(parameters),
      reach_(radius_of(parameters.footprint)),
      robot_in_world_(robot_in_world) {}

Twist Base::next_twist(const Twist& wished, double seconds) const {
  const Vector2 present{twist_.vx, twist_.vy};
  const Twist allowed = within_limits(wished, parameters_.speed, parameters_.turn_rate);
  const Vector2 change = Vector2(allowed.vx, allowed.vy) - present;
  const Vector2 next = present + limited(change, parameters_.acceleration * seconds);
  const double turn_step = parameters_.angular_acceleration * seconds;
  const double next_turn = twist_.va + std::clamp(allowed.va - twist_.va, -turn_step, turn_step);
  return {next.x(), next.y(), next_turn};
}

void Base::advance(const Twist& wished, double seconds, const Obstacles& obstacles) {
  const Twist twist = next_twist(wished, seconds);
  const Position goal = compose(robot_in_world_, move(twist, seconds));
  const Vector2 step = goal.location() - robot_in_world_.location();
  const Obstacles around = near(obstacles, robot_in_world_.location(), reach_ + step.norm());
  const auto surface_at = [&](const Position& position) {
    return touched_surface(transform(position, parameters_.footprint), position.location(), around);
  };

  const std::optional<Vector2> surface = surface_at(goal);
  if (!surface) {
    // Free; but a base that leans against something and does not move still leans.
    in_collision_ = in_collision_ && is_still(twist);
    robot_in_world_ = goal;
    twist_ = twist;
    return;
  }
  in_collision_ = true;
  const auto is_free = [&](const Position& position) { return !surface_at(position); };
  const Position before = robot_in_world_;
  robot_in_world_ = way_out(goal, *surface, is_free);
  twist_ = twist_between(before, robot_in_world_, seconds);
}

Position Base::way_out(const Position& goal, const Vector2& surface,
                       const std::function<bool(const Position&)>& is_free) const {
  // Along the surface that is touched, or along an own side, where a corner touches that.
  std::vector<Vector2> slides = {surface};
  for (const Segment& side : edges(transform(robot_in_world_, parameters_.footprint)))
    slides.push_back(direction(side));

  const Vector2 step = goal.location() - robot_in_world_.location();
  const Position turned{robot_in_world_.x, robot_in_world_.y, goal.a};
  Position best = is_free(turned) ? turned : robot_in_world_;
  double best_progress = 0.0;
  for (const Vector2& slide : slides) {
    const double progress = std::abs(slide.dot(step));
    if (progress <= best_progress) continue;
    const Vector2 location = robot_in_world_.location() + slide * slide.dot(step);
    const Position candidate{location.x(), location.y(), robot_in_world_.a};
    if (!is_free(candidate)) continue;
    best = candidate;
    best_progress = progress;
  }
  return best;
}

bool Base::would_touch(const Segment& segment) const {
  return touches(transform(robot_in_world_, parameters_.footprint), segment);
}

}  // namespace perceptor::sim
