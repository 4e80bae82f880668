#include "components/scan/current_map.hpp"

#include <utility>

namespace perceptor::scan {
namespace {

void place(Point& point, const WallEnd& end, double radius) {
  point.location = end.location;
  point.covariance = end.covariance;
  point.weight = 2.0 / end.covariance.trace();
  point.radius = radius;
}

/// The points of wall i are 2 i and 2 i + 1.
void add_wall(Map& map, const Wall& wall, double radius) {
  const Index index = add_segment(map, {wall.first.location, wall.last.location}, ObjectType::wall);
  Object& object = map.objects[static_cast<std::size_t>(index)];
  object.free_side = FreeSide::left;
  object.support = wall.support;
  object.line_covariance = wall.line_covariance;
  object.weight = 1.0 / wall.line_covariance(0, 0);
  const std::size_t first = map.points.size() - 2;
  place(map.points[first], wall.first, radius);
  place(map.points[first + 1], wall.last, radius);
}

void add_corner(Map& map, const Corner& corner, double radius) {
  const auto mark = [&](Point& end) {
    end.method = corner.method;
    if (corner.method == CornerMethod::intersection) place(end, corner.place, radius);
  };
  if (corner.before != kNoWall) mark(map.points[2 * corner.before + 1]);
  if (corner.after != kNoWall) mark(map.points[2 * corner.after]);
  if (corner.before != kNoWall || corner.after != kNoWall) return;
  Point alone;
  alone.method = corner.method;
  place(alone, corner.place, radius);
  map.points.push_back(std::move(alone));
}

}  // namespace

Map current_map(const Extraction& found, const CornerParameters& parameters) {
  Map map;
  for (const Wall& wall : found.walls) add_wall(map, wall, parameters.connection_radius);
  for (const Corner& corner : found.corners) add_corner(map, corner, parameters.connection_radius);
  return map;
}

}  // namespace perceptor::scan
