#include "tools/eval/explained_beams.hpp"

#include <algorithm>

#include "common/geometry/polygon.hpp"

namespace perceptor {

Share& Share::operator+=(const Share& other) {
  part += other.part;
  whole += other.whole;
  return *this;
}

double value(const Share& share) {
  return share.whole > 0 ? static_cast<double>(share.part) / static_cast<double>(share.whole) : 0.0;
}

std::vector<Vector2> robot_outline(const Map& map) {
  std::vector<Vector2> outline;
  const auto robot = std::ranges::find(map.objects, ObjectType::robot, &Object::type);
  if (robot == map.objects.end()) return outline;
  for (const Index point : robot->points)
    outline.push_back(map.points[static_cast<std::size_t>(point)].location);
  return outline;
}

std::vector<const Object*> walls_of(const Map& map) {
  std::vector<const Object*> walls;
  for (const Object& object : map.objects)
    if (object.type == ObjectType::wall && object.points.size() == 2) walls.push_back(&object);
  return walls;
}

Share explained_beams(const std::vector<BeamEnd>& ends, const Map& map,
                      const std::vector<Vector2>& robot, const ExplainedParameters& parameters) {
  std::vector<Segment> walls;
  for (const Object* wall : walls_of(map)) walls.push_back(segment(map, *wall));

  Share share;
  for (const BeamEnd& end : ends) {
    if (end.range >= parameters.max_range || contains(robot, end.location)) continue;
    const bool is_explained = std::ranges::any_of(walls, [&](const Segment& wall) {
      return distance(wall, end.location) < parameters.reach;
    });
    share += {is_explained ? 1 : 0, 1};
  }
  return share;
}

}  // namespace perceptor
