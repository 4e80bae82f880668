#include "common/model/map.hpp"

#include <algorithm>
#include <array>
#include <ostream>
#include <set>
#include <sstream>
#include <utility>

#include <Eigen/Geometry>

#include "common/geometry/polygon.hpp"

namespace perceptor {
namespace {

constexpr std::array<std::string_view, 11> kTypeNames = {
    "wall",          "door",  "possible door",    "cabinet",
    "origin",        "robot", "dynamic obstacle", "static obstacle",
    "safe distance", "test",  "start area"};

std::string_view name_of(ObjectType type) {
  const auto index = static_cast<std::size_t>(type);
  return index < kTypeNames.size() ? kTypeNames.at(index) : "unknown type";
}

template <class Item>
Index size_of(const std::vector<Item>& items) {
  return static_cast<Index>(items.size());
}

template <class Item>
bool is_in_range(const std::vector<Item>& items, Index index) {
  return index >= 0 && index < size_of(items);
}

/// Throws std::out_of_range for an index that points at nothing.
template <class Items>
auto& at(Items& items, Index index) {
  return items.at(static_cast<std::size_t>(index));
}

bool contains(const std::vector<Index>& indices, Index index) {
  return std::ranges::find(indices, index) != indices.end();
}

/// The longest beginning that fits and does not cut a UTF-8 character in two.
std::string_view shortened(std::string_view name) {
  if (name.size() <= kMaxNameLength) return name;
  const auto continues_character = [&name](std::size_t i) {
    return (static_cast<unsigned char>(name[i]) & 0xC0U) == 0x80U;
  };
  std::size_t end = kMaxNameLength;
  while (end > 0 && continues_character(end)) --end;
  return name.substr(0, end);
}

void transform(Point& point, const Position& map_in_new) {
  point.location = transform(map_in_new, point.location);
  if (point.covariance) {
    const Eigen::Matrix2d rotation = Eigen::Rotation2Dd(map_in_new.a).toRotationMatrix();
    point.covariance = rotation * *point.covariance * rotation.transpose();
  }
}

/// Where each item goes when those not kept are taken out; kNone: nowhere.
std::vector<Index> renumbering(const std::vector<bool>& kept) {
  std::vector<Index> new_index(kept.size(), kNone);
  Index next = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i]) new_index[i] = next++;
  }
  return new_index;
}

Index renumbered(const std::vector<Index>& new_index, Index index) {
  return is_in_range(new_index, index) ? at(new_index, index) : kNone;
}

void renumber(std::vector<Index>& indices, const std::vector<Index>& new_index) {
  for (Index& index : indices) index = renumbered(new_index, index);
  std::erase(indices, kNone);
}

template <class Item>
void keep_only(std::vector<Item>& items, const std::vector<bool>& kept) {
  std::size_t end = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!kept[i]) continue;
    if (end != i) items[end] = std::move(items[i]);
    ++end;
  }
  items.resize(end);
}

/// Points that stay when only some objects do: those of such an object, and lone corners.
std::vector<bool> points_kept(const Map& map, const std::vector<bool>& object_kept) {
  std::vector<bool> kept(map.points.size(), false);
  for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = map.points[i].parents.empty();
  for (std::size_t i = 0; i < object_kept.size(); ++i) {
    if (!object_kept[i]) continue;
    for (const Index point : map.objects[i].points) {
      if (is_in_range(map.points, point)) kept[static_cast<std::size_t>(point)] = true;
    }
  }
  return kept;
}

std::string find_fault_of_object(const Map& map, Index index) {
  const Object& object = at(map.objects, index);
  const std::string name = "object " + std::to_string(index);
  for (const Index point : object.points) {
    if (!is_in_range(map.points, point)) {
      return name + " has point " + std::to_string(point) + ", which is not there";
    }
    if (!contains(at(map.points, point).parents, index)) {
      return name + " has point " + std::to_string(point) + ", which does not know it";
    }
  }
  return {};
}

std::string find_fault_of_point(const Map& map, Index index) {
  const Point& point = at(map.points, index);
  const std::string name = "point " + std::to_string(index);
  for (const Index parent : point.parents) {
    if (!is_in_range(map.objects, parent)) {
      return name + " has parent " + std::to_string(parent) + ", which is not there";
    }
    if (!contains(at(map.objects, parent).points, index)) {
      return name + " has parent " + std::to_string(parent) + ", which does not know it";
    }
  }
  for (const Index other : {point.connected, point.projection}) {
    if (other == kNone) continue;
    if (!is_in_range(map.points, other)) {
      return name + " refers to point " + std::to_string(other) + ", which is not there";
    }
    if (other == index) return name + " refers to itself";
  }
  if (point.connected != kNone && at(map.points, point.connected).connected != index) {
    return name + " is connected to point " + std::to_string(point.connected) +
           ", which is not connected to it";
  }
  return {};
}

}  // namespace

NotASegment::NotASegment(const Object& object)
    : std::invalid_argument("object '" + object.name + "' (" + std::string(name_of(object.type)) +
                            ") has " + std::to_string(object.points.size()) +
                            " points where two are needed") {}

Index add_point(Map& map, const Vector2& location) {
  map.points.emplace_back().location = location;
  return size_of(map.points) - 1;
}

Index add_segment(Map& map, const Segment& segment, ObjectType type, std::string_view name) {
  const Index object = size_of(map.objects);
  const Index a = add_point(map, segment.a);
  const Index b = add_point(map, segment.b);
  at(map.points, a).parents = {object};
  at(map.points, b).parents = {object};
  Object& added = map.objects.emplace_back();
  added.name = shortened(name);
  added.type = type;
  added.points = {a, b};
  return object;
}

Segment segment(const Map& map, const Object& object) {
  if (object.points.size() != 2) throw NotASegment(object);
  return {at(map.points, object.points[0]).location, at(map.points, object.points[1]).location};
}

Segment segment(const Map& map, Index object) { return segment(map, at(map.objects, object)); }

std::vector<Vector2> corners(const Map& map, const Object& object) {
  std::vector<Vector2> corners;
  corners.reserve(object.points.size());
  for (const Index point : object.points)
    corners.push_back(map.points[static_cast<std::size_t>(point)].location);
  return corners;
}

std::vector<Segment> edges(const Map& map, const Object& object) {
  std::vector<Segment> all = edges(corners(map, object));
  const bool is_round = object.connection == Connection::closed && all.size() > 2;
  if (!is_round && !all.empty()) all.pop_back();
  return all;
}

void set_segment(Map& map, Index object, const Segment& segment) {
  const Object& moved = at(map.objects, object);
  if (moved.points.size() != 2) throw NotASegment(moved);
  at(map.points, moved.points[0]).location = segment.a;
  at(map.points, moved.points[1]).location = segment.b;
}

double angle(const Map& map, const Object& object) { return angle(segment(map, object)); }

double length(const Map& map, const Object& object) { return length(segment(map, object)); }

double smallest_relative_angle(const Map& map, const Object& first, const Object& second) {
  return smallest_relative_angle(segment(map, first), segment(map, second));
}

double angle_between(const Map& map, const Object& first, const Object& second) {
  return angle_between(segment(map, first), segment(map, second));
}

double average_perpendicular_distance(const Map& map, const Object& first, const Object& second) {
  return average_perpendicular_distance(segment(map, first), segment(map, second));
}

double gap_distance(const Map& map, const Object& first, const Object& second) {
  return gap_distance(segment(map, first), segment(map, second));
}

void transform(Map& map, const Object& object, const Position& map_in_new) {
  // A set: a ring may name its first point again as its last.
  const std::set<Index> points(object.points.begin(), object.points.end());
  for (const Index point : points) transform(at(map.points, point), map_in_new);
}

bool same_parent_object(const Map& map, Index first, Index second) {
  const std::vector<Index>& parents = at(map.points, first).parents;
  const std::vector<Index>& others = at(map.points, second).parents;
  return std::ranges::any_of(parents, [&others](Index parent) { return contains(others, parent); });
}

void connect(Map& map, Index first, Index second) {
  if (first == second) return;
  disconnect(map, first);
  disconnect(map, second);
  at(map.points, first).connected = second;
  at(map.points, second).connected = first;
  at(map.points, first).property = PointProperty::connected;
  at(map.points, second).property = PointProperty::connected;
}

void disconnect(Map& map, Index point) {
  const Index other = std::exchange(at(map.points, point).connected, kNone);
  if (other == kNone) return;
  at(map.points, point).property = PointProperty::floating;
  if (at(map.points, other).connected == point) disconnect(map, other);
}

Map transform(const Map& map, const Position& map_in_new) {
  Map seen_from_new = map;
  for (Point& point : seen_from_new.points) transform(point, map_in_new);
  return seen_from_new;
}

void remove_objects(Map& map) {
  std::vector<bool> object_kept(map.objects.size());
  for (std::size_t i = 0; i < object_kept.size(); ++i) object_kept[i] = !map.objects[i].remove;
  const std::vector<bool> point_kept = points_kept(map, object_kept);
  const std::vector<Index> new_object = renumbering(object_kept);
  const std::vector<Index> new_point = renumbering(point_kept);

  keep_only(map.objects, object_kept);
  keep_only(map.points, point_kept);
  for (Object& object : map.objects) renumber(object.points, new_point);
  for (Point& point : map.points) {
    renumber(point.parents, new_object);
    const bool was_connected = point.connected != kNone;
    point.connected = renumbered(new_point, point.connected);
    point.projection = renumbered(new_point, point.projection);
    const bool lost_connection = was_connected && point.connected == kNone;
    if (lost_connection) point.property = PointProperty::floating;
  }
}

void set_objects_old(Map& map) {
  for (Object& object : map.objects) object.is_new = false;
}

void print(std::ostream& out, const Map& map) {
  std::ostringstream text;  // leaves the caller's stream as it is formatted
  text.precision(3);
  text << std::fixed;
  for (const Object& object : map.objects) {
    text << object.id << ' ' << name_of(object.type) << " '" << object.name << "' weight "
         << object.weight << ':';
    for (const Index index : object.points) {
      const Point& point = at(map.points, index);
      text << " (" << point.location.x() << ", " << point.location.y() << ')';
    }
    text << (object.is_new ? " new" : "") << (object.remove ? " remove" : "") << '\n';
  }
  out << text.str();
}

std::string find_broken_reference(const Map& map) {
  for (Index i = 0; i < size_of(map.objects); ++i) {
    if (std::string fault = find_fault_of_object(map, i); !fault.empty()) return fault;
  }
  for (Index i = 0; i < size_of(map.points); ++i) {
    if (std::string fault = find_fault_of_point(map, i); !fault.empty()) return fault;
  }
  return {};
}

}  // namespace perceptor
