#include "components/identify/identify.hpp"

#include <algorithm>

namespace perceptor::identify {
namespace {

constexpr std::int32_t kDoorColour = 0x00A000;          // green
constexpr std::int32_t kPossibleDoorColour = 0xFFA500;  // orange

const Object& object_at(const Map& map, Index index) {
  return map.objects[static_cast<std::size_t>(index)];
}

Point& point_of(Map& map, const Object& object, std::size_t which) {
  return map.points[static_cast<std::size_t>(object.points[which])];
}

void refer_to_wall_end(Map& map, const Object& object, std::size_t which,
                       const OpeningBound& bound) {
  if (bound.point == kNone) return;
  Point& wall_end = map.points[static_cast<std::size_t>(bound.point)];
  if (object.type == ObjectType::door) wall_end.property = PointProperty::convex;
  Point& point = point_of(map, object, which);
  point.projection = bound.point;
  point.covariance = wall_end.covariance;
  point.weight = wall_end.weight;
}

void add_opening(Map& map, const Opening& opening) {
  const bool is_door = opening.type == ObjectType::door;
  const Segment between{opening.first.location, opening.second.location};
  const Index index = add_segment(map, between, opening.type, is_door ? "door" : "possible door");
  const Object& first_wall = object_at(map, opening.first.wall);
  const Object& second_wall = object_at(map, opening.second.wall);
  Object& object = map.objects[static_cast<std::size_t>(index)];
  object.draw_type = DrawType::lines;
  object.colour = is_door ? kDoorColour : kPossibleDoorColour;
  object.free_side = opening.free_side;
  object.weight = std::min(first_wall.weight, second_wall.weight);
  object.confidence = opening.confidence;
  object.reason = opening.reason;
  object.first_seen = std::max(first_wall.first_seen, second_wall.first_seen);
  object.last_seen = std::min(first_wall.last_seen, second_wall.last_seen);
  refer_to_wall_end(map, object, 0, opening.first);
  refer_to_wall_end(map, object, 1, opening.second);
}

}  // namespace

std::size_t identify(Map& map, const Vector2& robot, const IdentifyParameters& parameters) {
  const std::vector<Wall> walls = read_walls(map);
  classify_corners(map, walls, robot, parameters.corners);
  const std::vector<Opening> openings =
      find_openings(map, walls, robot, parameters.openings, parameters.confidence);
  for (const Opening& opening : openings) add_opening(map, opening);
  return openings.size();
}

void remove_last_opening(Map& map) {
  map.objects.pop_back();
  map.points.resize(map.points.size() - 2);
}

}  // namespace perceptor::identify
