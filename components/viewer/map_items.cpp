#include "components/viewer/map_items.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

#include "common/text/format.hpp"
#include "common/time/stamp.hpp"

namespace perceptor::viewer {
namespace {

constexpr double kMillimetres = 1000.0;
constexpr double kDegrees = 180.0 / std::numbers::pi;

std::string name_of(const Object& object, std::string_view what) {
  std::string name(what);
  if (object.id != kNone) name += format(" %d", object.id);
  if (!object.name.empty()) name += " (" + object.name + ")";
  return name;
}

/// What an object is, how long, how certain, and why it was formed.
std::string describe(const Map& map, const Object& object, std::string_view what) {
  std::string line = name_of(object, what);
  if (object.points.size() == 2) line += format(", %.2f m", length(map, object));
  if (object.line_covariance) {
    const Eigen::Matrix2d& c = *object.line_covariance;
    line += format(", sigma %.1f mm and %.2f deg", kMillimetres * std::sqrt(c(0, 0)),
                   kDegrees * std::sqrt(c(1, 1)));
  }
  if (object.support > 0) line += format(", %d beams", object.support);
  if (object.weight > 0.0) line += format(", weight %.1f", object.weight);
  if (object.confidence > 0.0) line += format(", confidence %.2f", object.confidence);
  if (object.first_seen > 0 && object.last_seen > object.first_seen)
    line += format(", seen for %.1f s", seconds_between(object.first_seen, object.last_seen));
  if (!object.reason.empty()) line += ": " + object.reason;
  return line;
}

std::string describe(const Point& point, std::string_view what) {
  std::string line(what);
  line += format(" at (%.3f, %.3f) m from where it began", point.location.x(), point.location.y());
  if (point.covariance) {
    const Eigen::Matrix2d& c = *point.covariance;
    line += format(", sigma %.1f mm by %.1f mm", kMillimetres * std::sqrt(c(0, 0)),
                   kMillimetres * std::sqrt(c(1, 1)));
  }
  if (point.weight > 0.0) line += format(", weight %.1f", point.weight);
  return line;
}

Item item(const Map& map, const Object& object, Mark mark) {
  Item item{mark, corners(map, object), describe(map, object, look_of(mark).label)};
  const bool is_outline = object.connection == Connection::closed && item.points.size() > 2;
  if (is_outline && look_of(mark).shape == Shape::line) item.points.push_back(item.points.front());
  return item;
}

/// A mark for each object that `mark_of` gives one.
template <class MarkOf>
std::vector<Item> items_of(const Map& map, const MarkOf& mark_of) {
  std::vector<Item> items;
  for (const Object& object : map.objects) {
    const std::optional<Mark> mark = mark_of(object);
    if (mark && !object.points.empty()) items.push_back(item(map, object, *mark));
  }
  return items;
}

Mark mark_of(PointProperty property) {
  switch (property) {
    case PointProperty::convex:
      return Mark::convex_corner;
    case PointProperty::concave:
      return Mark::concave_corner;
    case PointProperty::connected:
      return Mark::corner;
    case PointProperty::floating:
      break;
  }
  return Mark::loose_end;
}

bool is_of_a_wall(const Map& map, const Point& point) {
  const bool is_lone_corner = point.parents.empty();
  return is_lone_corner || std::ranges::any_of(point.parents, [&](Index parent) {
           return map.objects[static_cast<std::size_t>(parent)].type == ObjectType::wall;
         });
}

Mark wall_mark(const Object& wall) {
  if (wall.reason == "confirmed") return Mark::confirmed_wall;
  return wall.reason == "contradicted" ? Mark::contradicted_wall : Mark::unseen_wall;
}

Mark door_mark(const Object& door) {
  if (door.reason == "open") return Mark::open_door;
  return door.reason == "shut" ? Mark::shut_door : Mark::unseen_door;
}

}  // namespace

std::vector<Item> current_map_items(const Map& current_map) {
  return items_of(current_map, [](const Object& object) -> std::optional<Mark> {
    if (object.type == ObjectType::wall) return Mark::current_wall;
    return std::nullopt;
  });
}

std::vector<Item> local_map_items(const Map& local_map) {
  return items_of(local_map, [](const Object& object) -> std::optional<Mark> {
    if (object.type == ObjectType::wall) return Mark::local_wall;
    if (object.type == ObjectType::origin) return Mark::origin;
    return std::nullopt;
  });
}

std::vector<Item> identified_items(const Map& identified_map) {
  std::vector<Item> items =
      items_of(identified_map, [](const Object& object) -> std::optional<Mark> {
        if (object.type == ObjectType::door) return Mark::door;
        if (object.type == ObjectType::possible_door) return Mark::possible_door;
        return std::nullopt;
      });
  for (Item& item : items)
    if (item.mark == Mark::door) item.label = look_of(Mark::door).label;
  for (std::size_t i = 0; i < identified_map.points.size(); ++i) {
    const Point& point = identified_map.points[i];
    const bool is_shown_already =
        point.connected != kNone && static_cast<std::size_t>(point.connected) < i;
    if (is_shown_already || !is_of_a_wall(identified_map, point)) continue;
    const Mark mark = mark_of(point.property);
    items.push_back({mark, {point.location}, describe(point, look_of(mark).label)});
  }
  return items;
}

std::vector<Item> robot_items(const Map& local_map) {
  return items_of(local_map, [](const Object& object) -> std::optional<Mark> {
    if (object.type == ObjectType::robot) return Mark::robot;
    if (object.type == ObjectType::safe_distance) return Mark::safe_distance;
    return std::nullopt;
  });
}

std::vector<Item> global_map_items(const Map& global_map) {
  return items_of(global_map, [](const Object& object) -> std::optional<Mark> {
    if (object.type == ObjectType::wall) return Mark::map_wall;
    if (object.type == ObjectType::cabinet) return Mark::map_cabinet;
    if (object.type == ObjectType::door) return Mark::map_door;
    if (object.type == ObjectType::start_area) return Mark::start_area;
    return std::nullopt;
  });
}

std::vector<Item> combined_map_items(const Map& combined_map) {
  return items_of(combined_map, [](const Object& object) -> std::optional<Mark> {
    if (object.type == ObjectType::wall || object.type == ObjectType::cabinet)
      return wall_mark(object);
    if (object.type == ObjectType::door) return door_mark(object);
    return std::nullopt;
  });
}

std::vector<Item> obstacle_items(const Map& combined_map) {
  return items_of(combined_map, [](const Object& object) -> std::optional<Mark> {
    if (object.type == ObjectType::static_obstacle) return Mark::static_obstacle;
    if (object.type == ObjectType::dynamic_obstacle) return Mark::dynamic_obstacle;
    return std::nullopt;
  });
}

std::vector<Item> true_world_items(const Map& world) {
  return items_of(world, [](const Object& object) -> std::optional<Mark> {
    const bool is_open_door = object.type == ObjectType::door && object.reason == "open";
    if (is_open_door) return std::nullopt;
    return Mark::true_wall;
  });
}

}  // namespace perceptor::viewer
