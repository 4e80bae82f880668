#include "tools/eval/true_world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace perceptor {
namespace {

void append_sides(const Map& map, ObjectType type, Surface surface, std::vector<TrueSide>& sides) {
  for (const Object& object : map.objects) {
    if (object.type != type || (surface == Surface::leaf && object.reason != "shut")) continue;
    for (const Segment& edge : edges(map, object))
      if (length(edge) > 0.0) sides.push_back({edge, surface});
  }
}

void add_corners(TrueWorld& world, const TrueWorldParameters& parameters) {
  const auto joins = [&](const Vector2& p, const Vector2& q) {
    return distance(p, q) < parameters.join;
  };
  for (std::size_t i = 0; i < world.sides.size(); ++i)
    for (std::size_t j = i + 1; j < world.sides.size(); ++j) {
      const TrueSide& s = world.sides[i];
      const TrueSide& t = world.sides[j];
      if (s.surface == Surface::leaf || t.surface == Surface::leaf) continue;
      if (smallest_relative_angle(s.segment, t.segment) < parameters.min_turn) continue;
      for (const Vector2& end : {s.segment.a, s.segment.b})
        if (joins(end, t.segment.a) || joins(end, t.segment.b))
          world.corners.push_back({end, {i, j}});
    }
}

/// The short side across the wall's thickness at one end of an opening; without one, the end.
Segment jamb_at(const TrueWorld& world, const Segment& opening, const Vector2& end,
                const TrueWorldParameters& parameters) {
  for (const TrueSide& side : world.sides)
    if (side.surface == Surface::wall && length(side.segment) < parameters.max_thickness &&
        distance(side.segment, end) < parameters.join &&
        smallest_relative_angle(side.segment, opening) > std::numbers::pi / 4.0)
      return side.segment;
  return {end, end};
}

/// The wall that begins at a jamb, and runs away from the opening.
std::size_t adjoining(const TrueWorld& world, const Vector2& jamb, const Vector2& across,
                      const TrueWorldParameters& parameters) {
  for (std::size_t i = 0; i < world.sides.size(); ++i) {
    const auto& [side, surface] = world.sides[i];
    if (surface != Surface::wall) continue;
    const bool begins = distance(side.a, jamb) < parameters.join;
    if (!begins && distance(side.b, jamb) >= parameters.join) continue;
    const Vector2 away = begins ? direction(side) : Vector2(-direction(side));
    if (away.dot(unit(jamb - across)) > std::numbers::sqrt2 / 2.0) return i;
  }
  return kNoSide;
}

std::vector<OpeningFace> faces_of(const TrueWorld& world, const Segment& opening,
                                  const TrueWorldParameters& parameters) {
  const auto sorted = [&](Segment jamb) {
    if (signed_distance(opening, jamb.a) > signed_distance(opening, jamb.b))
      std::swap(jamb.a, jamb.b);
    return jamb;
  };
  const Segment first = sorted(jamb_at(world, opening, opening.a, parameters));
  const Segment second = sorted(jamb_at(world, opening, opening.b, parameters));
  std::vector<OpeningFace> faces;
  const auto add = [&](const Segment& face) {
    faces.push_back({face,
                     {adjoining(world, face.a, face.b, parameters),
                      adjoining(world, face.b, face.a, parameters)}});
  };
  add({first.a, second.a});
  if (length(first) > 0.0 && length(second) > 0.0) add({first.b, second.b});
  return faces;
}

double from_furniture(const TrueWorld& world, const std::vector<OpeningFace>& faces) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const OpeningFace& face : faces)
    for (const TrueSide& side : world.sides)
      if (side.surface == Surface::furniture)
        for (const Vector2& jamb : {face.segment.a, face.segment.b})
          nearest = std::min(nearest, distance(side.segment, jamb));
  return nearest;
}

}  // namespace

TrueWorld true_world(const Map& map, const TrueWorldParameters& parameters) {
  TrueWorld world;
  append_sides(map, ObjectType::wall, Surface::wall, world.sides);
  append_sides(map, ObjectType::cabinet, Surface::furniture, world.sides);
  append_sides(map, ObjectType::static_obstacle, Surface::furniture, world.sides);
  append_sides(map, ObjectType::door, Surface::leaf, world.sides);
  add_corners(world, parameters);
  for (const Object& object : map.objects) {
    if (object.type != ObjectType::door) continue;
    std::vector<OpeningFace> faces = faces_of(world, segment(map, object), parameters);
    const double gap = from_furniture(world, faces);
    world.openings.push_back({object.id, std::move(faces), object.reason != "shut", gap});
  }
  return world;
}

}  // namespace perceptor
