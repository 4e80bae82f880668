#include "components/localize/local_wall.hpp"

#include <utility>

namespace perceptor::localize {
namespace {

constexpr double kUnknownOffsetVariance = 4e-4;   // [m^2] of a wall that comes without covariance
constexpr double kUnknownAngleVariance = 2.5e-3;  // [rad^2]
constexpr double kUnknownEndVariance = 4e-4;      // [m^2]

LocalWall local_wall(const Map& map, const Object& object) {
  std::array<Index, 2> ends = {object.points[0], object.points[1]};
  LocalWall wall;
  wall.covariance = object.line_covariance.value_or(
      Eigen::Vector2d(kUnknownOffsetVariance, kUnknownAngleVariance).asDiagonal());
  if (object.free_side == FreeSide::right) {
    std::swap(ends[0], ends[1]);
    wall.covariance(0, 1) = -wall.covariance(0, 1);
    wall.covariance(1, 0) = -wall.covariance(1, 0);
  }
  const auto point = [&](std::size_t end) -> const Point& {
    return map.points[static_cast<std::size_t>(ends[end])];
  };
  wall.segment = {point(0).location, point(1).location};
  wall.line = line_of(wall.segment);
  for (const std::size_t end : {0U, 1U}) {
    wall.is_corner[end] = point(end).method != CornerMethod::none;
    wall.end_variance[end] = point(end).covariance
                                 ? wall.line.along.dot(*point(end).covariance * wall.line.along)
                                 : kUnknownEndVariance;
  }
  return wall;
}

}  // namespace

std::vector<LocalWall> local_walls(const Map& local_map, std::int64_t since) {
  std::vector<LocalWall> walls;
  for (const Object& object : local_map.objects) {
    const bool is_wall = object.type == ObjectType::wall && object.points.size() == 2;
    if (!is_wall || object.free_side == FreeSide::unknown || object.last_seen < since) continue;
    LocalWall wall = local_wall(local_map, object);
    if (wall.line.length > 0.0) walls.push_back(wall);
  }
  return walls;
}

LocalWall transform(const Position& map_in_new, const LocalWall& wall) {
  LocalWall moved = wall;
  moved.segment = perceptor::transform(map_in_new, wall.segment);
  moved.line = line_of(moved.segment);
  return moved;
}

}  // namespace perceptor::localize
