#include "components/identify/walls.hpp"

#include <cmath>

namespace perceptor::identify {
namespace {

/// Below this a wall has no direction [m].
constexpr double kNoLength = 1e-6;

bool is_there(const Map& map, Index point) {
  return point >= 0 && static_cast<std::size_t>(point) < map.points.size();
}

bool has_two_points(const Map& map, const Object& object) {
  return object.points.size() == 2 && is_there(map, object.points[0]) &&
         is_there(map, object.points[1]);
}

Vector2 free_normal(const Vector2& along, FreeSide side) {
  return static_cast<double>(side) * perpendicular(along);
}

std::optional<Wall> read_wall(const Map& map, std::size_t index) {
  const Object& object = map.objects[index];
  if (object.type != ObjectType::wall || !has_two_points(map, object)) return std::nullopt;
  const Segment between = segment(map, object);
  const double wall_length = length(between);
  if (!std::isfinite(wall_length) || wall_length < kNoLength) return std::nullopt;
  const Vector2 along = (between.b - between.a) / wall_length;
  Wall wall{.object = static_cast<Index>(index),
            .length = wall_length,
            .middle = middle(between),
            .free = free_normal(along, object.free_side),
            .ends = {}};
  wall.ends[0] = {object.points[0], between.a, -along, std::nullopt};
  wall.ends[1] = {object.points[1], between.b, along, std::nullopt};
  return wall;
}

void find_partners(const Map& map, std::vector<Wall>& walls) {
  std::vector<std::optional<EndHandle>> end_at(map.points.size());
  for (std::size_t w = 0; w < walls.size(); ++w) {
    for (std::size_t e = 0; e < 2; ++e) {
      end_at[static_cast<std::size_t>(walls[w].ends[e].point)] = {w, e};
    }
  }
  for (std::size_t w = 0; w < walls.size(); ++w) {
    for (WallEnd& end : walls[w].ends) {
      const Index connected = map.points[static_cast<std::size_t>(end.point)].connected;
      if (!is_there(map, connected)) continue;
      const auto other = end_at[static_cast<std::size_t>(connected)];
      if (other && other->wall != w) end.partner = other;
    }
  }
}

}  // namespace

std::vector<Wall> read_walls(const Map& map) {
  std::vector<Wall> walls;
  walls.reserve(map.objects.size());
  for (std::size_t i = 0; i < map.objects.size(); ++i) {
    if (const auto wall = read_wall(map, i)) walls.push_back(*wall);
  }
  find_partners(map, walls);
  return walls;
}

}  // namespace perceptor::identify
