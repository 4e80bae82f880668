#include "components/merge/markers.hpp"

#include <cmath>
#include <numbers>
#include <string_view>

namespace perceptor::merge {
namespace {

constexpr std::int32_t kGrey = 0x808080;
constexpr std::int32_t kBlue = 0x2060C0;
constexpr std::int32_t kOrange = 0xE08000;

void add_marker(Map& map, const std::vector<Vector2>& outline, ObjectType type,
                std::string_view name, std::int32_t colour) {
  const auto index = static_cast<Index>(map.objects.size());
  Object marker;
  marker.name = name;
  marker.type = type;
  marker.draw_type = outline.size() == 1 ? DrawType::points : DrawType::lines;
  marker.connection = outline.size() == 1 ? Connection::open : Connection::closed;
  marker.colour = colour;
  marker.is_new = false;
  for (const Vector2& location : outline) {
    const Index point = add_point(map, location);
    map.points[static_cast<std::size_t>(point)].parents = {index};
    marker.points.push_back(point);
  }
  map.objects.push_back(marker);
}

}  // namespace

void add_origin(Map& map, const Position& robot_in_local) {
  add_marker(map, {inverse(robot_in_local).location()}, ObjectType::origin, "origin", kGrey);
}

void add_robot(Map& map, const std::vector<Vector2>& footprint) {
  add_marker(map, footprint, ObjectType::robot, "robot", kBlue);
}

void add_safe_distance(Map& map, double distance) {
  constexpr int kSides = 8;
  const double half_turn_of_side = std::numbers::pi / kSides;
  const double to_corner = distance / std::cos(half_turn_of_side);
  std::vector<Vector2> outline;
  for (int i = 0; i < kSides; ++i) {
    const double bearing = (2 * i + 1) * half_turn_of_side;
    outline.emplace_back(to_corner * std::cos(bearing), to_corner * std::sin(bearing));
  }
  add_marker(map, outline, ObjectType::safe_distance, "safe distance", kOrange);
}

}  // namespace perceptor::merge
