#include "tools/eval/room_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/geometry/angle.hpp"

namespace perceptor {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Counter-clockwise about the origin, the corners in nearly even directions.
Outline star(RoomRandom& random, int corners, double nearest, double farthest) {
  const double first = uniform(random, 0.0, kTurn);
  Outline outline;
  for (int i = 0; i < corners; ++i) {
    const double direction = first + kTurn * (i + uniform(random, -0.3, 0.3)) / corners;
    const double radius = uniform(random, nearest, farthest);
    outline.emplace_back(radius * std::cos(direction), radius * std::sin(direction));
  }
  return outline;
}

/// [rad] between the two sides that meet in the corner, on the inside of a counter-clockwise
/// outline.
double inner_angle(const Outline& outline, std::size_t corner) {
  const std::size_t size = outline.size();
  const Segment before{outline[(corner + size - 1) % size], outline[corner]};
  const Segment after{outline[corner], outline[(corner + 1) % size]};
  return std::numbers::pi - angle_difference(angle(before), angle(after));
}

bool has_acute_and_obtuse_corner(const Outline& outline) {
  bool has_acute = false;
  bool has_obtuse = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const double angle = inner_angle(outline, i);
    has_acute |= angle < 1.4;
    has_obtuse |= angle > 1.75 && angle < 2.9;
  }
  return has_acute && has_obtuse;
}

bool has_sides_between(const Outline& outline, double shortest, double longest) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const double side = distance(outline[i], outline[(i + 1) % outline.size()]);
    if (side < shortest || side > longest) return false;
  }
  return true;
}

}  // namespace

Outline rectangle(double width, double height) {
  return {{0.0, 0.0}, {width, 0.0}, {width, height}, {0.0, height}};
}

Outline l_shape(RoomRandom& random) {
  const double width = uniform(random, 5.0, 9.0);
  const double height = uniform(random, 5.0, 9.0);
  const double x = width * uniform(random, 0.3, 0.7);
  const double y = height * uniform(random, 0.3, 0.7);
  return {{0.0, 0.0}, {width, 0.0}, {width, y}, {x, y}, {x, height}, {0.0, height}};
}

Outline slanted_outline(RoomRandom& random) {
  Outline outline;
  do {
    outline = star(random, uniform_int(random, 5, 8), 2.0, 5.5);
  } while (!has_acute_and_obtuse_corner(outline) || !has_sides_between(outline, 0.8, 9.0) ||
           !is_sound({{outline}}));
  return outline;
}

Outline box(double length, double width, double angle) {
  Outline outline;
  for (const Vector2& corner :
       {Vector2(-1.0, -1.0), Vector2(-1.0, 1.0), Vector2(1.0, 1.0), Vector2(1.0, -1.0)}) {
    const Vector2 unturned(0.5 * length * corner.x(), 0.5 * width * corner.y());
    outline.push_back(transform(unturned, angle, Vector2::Zero()));
  }
  return outline;
}

Outline polygon_thing(RoomRandom& random) {
  Outline outline;
  do {
    outline = star(random, uniform_int(random, 3, 6), 0.25, 0.9);
  } while (!has_sides_between(outline, 0.3, 1.5) || !is_sound({{outline}}));
  std::ranges::reverse(outline);
  return outline;
}

Outline moved(Outline outline, const Vector2& by) {
  for (Vector2& corner : outline) corner += by;
  return outline;
}

}  // namespace perceptor
