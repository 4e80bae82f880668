#include "components/merge/local_map.hpp"

#include <map>
#include <string>

namespace perceptor::merge {
namespace {

void fill_point(Point& point, const Wall& wall, const Line& line, std::size_t end,
                double end_sigma) {
  point.covariance = end_covariance(wall, line, end);
  point.method = wall.ends[end].method;
  point.radius = wall.ends[end].radius;
  point.weight = end_sigma * end_sigma / wall.ends[end].variance;
}

void fill_object(Object& object, const Wall& wall) {
  object.id = wall.id;
  object.is_new = wall.is_new;
  object.free_side = FreeSide::left;
  object.support = wall.support;
  object.weight = wall.weight;
  object.line_covariance = wall.covariance;
  object.first_seen = wall.first_seen;
  object.last_seen = wall.last_seen;
}

Index point_of(const Map& map, Index object, std::size_t end) {
  return map.objects[static_cast<std::size_t>(object)].points[end];
}

/// The head of one and the tail of the other lie on top of each other.
void connect_corner(Map& map, Index arriving, Index leaving) {
  const Index head = point_of(map, arriving, kHead);
  const Index tail = point_of(map, leaving, kTail);
  connect(map, head, tail);
  map.points[static_cast<std::size_t>(head)].projection = tail;
  map.points[static_cast<std::size_t>(tail)].projection = head;
}

}  // namespace

Map confirmed_map(const std::vector<Wall>& walls, const Position& robot_in_local,
                  double end_sigma) {
  const Position local_in_robot = inverse(robot_in_local);
  Map map;
  map.objects.reserve(walls.size());
  map.points.reserve(2 * walls.size());
  std::map<std::int32_t, Index> object_of_id;
  for (const Wall& wall : walls) {
    if (!wall.confirmed) continue;
    const Segment segment = perceptor::transform(local_in_robot, wall.segment);
    const Line line = line_of(segment);
    const Index added =
        add_segment(map, segment, ObjectType::wall, "wall " + std::to_string(wall.id));
    object_of_id[wall.id] = added;
    fill_object(map.objects[static_cast<std::size_t>(added)], wall);
    for (const std::size_t end : {kTail, kHead})
      fill_point(map.points[static_cast<std::size_t>(point_of(map, added, end))], wall, line, end,
                 end_sigma);
  }
  for (const Wall& wall : walls) {
    const auto arriving = object_of_id.find(wall.id);
    const auto leaving = object_of_id.find(wall.ends[kHead].connected);
    if (arriving != object_of_id.end() && leaving != object_of_id.end())
      connect_corner(map, arriving->second, leaving->second);
  }
  return map;
}

}  // namespace perceptor::merge
