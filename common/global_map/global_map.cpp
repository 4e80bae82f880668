#include "common/global_map/global_map.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "common/floorplan/outline.hpp"
#include "common/global_map/content_id.hpp"
#include "common/global_map/surfaces.hpp"

namespace perceptor::global_map {
namespace {

constexpr double kCertain = 1.0;                     // weight and confidence of what the file says
constexpr std::int32_t kCabinetColour = 0x8B5A2B;    // brown
constexpr std::int32_t kDoorColour = 0x00A000;       // green
constexpr std::int32_t kStartAreaColour = 0x3060FF;  // blue

Point& at(Map& map, Index point) { return map.points[static_cast<std::size_t>(point)]; }

PointProperty kind_of_corner(const Surface& surface, const Surface& next, double straight_angle) {
  const double turn = turn_between(surface, next);
  if (std::abs(turn) < straight_angle) return PointProperty::connected;
  return turn > 0.0 ? PointProperty::concave : PointProperty::convex;
}

/// The one nearest to a place [m], of some points; none farther than `reach` [m].
template <class Points>
Index nearest_point(const Map& map, const Points& candidates, const Vector2& place, double reach) {
  Index nearest = kNone;
  for (const Index candidate : candidates) {
    const double away = distance(map.points[static_cast<std::size_t>(candidate)].location, place);
    if (away > reach) continue;
    nearest = candidate;
    reach = away;
  }
  return nearest;
}

class Builder {
 public:
  Builder(const Floorplan& plan, const Surfaces& surfaces, const GlobalMapParameters& parameters)
      : plan_(plan), surfaces_(surfaces.surfaces), parameters_(parameters) {}

  Map build() {
    for (std::size_t i = 0; i < surfaces_.size(); ++i)
      if (surfaces_[i].cabinet == kNoCabinet) add_wall(i);
    for (std::size_t i = 0; i < plan_.cabinets.size(); ++i) add_cabinet(i);
    for (std::size_t i = 0; i < surfaces_.size(); ++i) add_corner(i);
    for (std::size_t i = 0; i < plan_.doors.size(); ++i) add_door(i);
    for (std::size_t i = 0; i < plan_.start_area.size(); ++i) add_start_area(i);
    return std::move(map_);
  }

 private:
  Object& add_object(ObjectType type, const std::vector<Vector2>& corners, std::string_view name) {
    const auto index = static_cast<Index>(map_.objects.size());
    Object object;
    object.id = index;
    object.name = name;
    object.type = type;
    object.connection = corners.size() > 2 ? Connection::closed : Connection::open;
    object.is_new = false;
    object.weight = kCertain;
    for (const Vector2& corner : corners) {
      const Index point = add_point(map_, corner);
      at(map_, point).parents = {index};
      at(map_, point).method = CornerMethod::map;
      at(map_, point).weight = kCertain;
      object.points.push_back(point);
    }
    return map_.objects.emplace_back(std::move(object));
  }

  void add_wall(std::size_t surface) {
    const auto& [a, b] = surfaces_[surface].segment;
    Object& wall = add_object(ObjectType::wall, {a, b}, "wall");
    wall.free_side = FreeSide::left;
    wall_of_.resize(surfaces_.size(), kNone);
    wall_of_[surface] = wall.id;
  }

  void add_cabinet(std::size_t number) {
    std::vector<Vector2> outline = corners(plan_, plan_.cabinets[number]);
    double area = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i)
      area += cross(outline[i] - outline[0], outline[(i + 1) % outline.size()] - outline[0]);
    // Clockwise, and the front stays the first side.
    if (area > 0.0) {
      std::ranges::reverse(outline);
      std::ranges::rotate(outline, outline.end() - 2);
    }
    Object& cabinet = add_object(ObjectType::cabinet, outline, "cabinet " + std::to_string(number));
    cabinet.free_side = FreeSide::left;
    cabinet.colour = kCabinetColour;
    cabinets_.push_back(cabinet.id);
  }

  /// The point of the map that is one end of a surface; none where a wall meets a cabinet's side
  /// between its corners.
  Index point_of(const Surface& surface, bool at_end) const {
    const auto index = static_cast<std::size_t>(&surface - surfaces_.data());
    const Vector2& place = at_end ? surface.segment.b : surface.segment.a;
    if (surface.cabinet == kNoCabinet) return object(wall_of_[index]).points[at_end ? 1 : 0];
    const auto& outline = object(cabinets_[static_cast<std::size_t>(surface.cabinet)]).points;
    return nearest_point(map_, outline, place, parameters_.free_space.snap);
  }

  void add_corner(std::size_t index) {
    const Surface& surface = surfaces_[index];
    const bool begins_at_opening = surface.previous == kNowhere;
    if (begins_at_opening) end_at_opening(point_of(surface, false));
    if (surface.next == kNowhere) return end_at_opening(point_of(surface, true));

    const Surface& next = surfaces_[surface.next];
    const PointProperty kind = kind_of_corner(surface, next, parameters_.straight_angle);
    const Index end = point_of(surface, true);
    const Index begin = point_of(next, false);
    for (const Index point : {end, begin})
      if (point != kNone) at(map_, point).property = kind;
    const bool is_free = end != kNone && begin != kNone && end != begin &&
                         at(map_, end).connected == kNone && at(map_, begin).connected == kNone;
    if (!is_free) return;
    at(map_, end).connected = begin;
    at(map_, begin).connected = end;
  }

  void end_at_opening(Index point) {
    if (point != kNone) at(map_, point).property = PointProperty::convex;
  }

  void add_door(std::size_t number) {
    auto [a, b] = opening(plan_, plan_.doors[number]);
    const bool is_in_order = std::pair(a.x(), a.y()) <= std::pair(b.x(), b.y());
    if (!is_in_order) std::swap(a, b);
    const Object& door = add_object(ObjectType::door, {a, b}, "door " + std::to_string(number));
    for (const Index point : door.points)
      at(map_, point).projection = wall_corner_at(at(map_, point).location);
    map_.objects.back().colour = kDoorColour;
    map_.objects.back().confidence = kCertain;
    map_.objects.back().reason = "on the map";
  }

  Index wall_corner_at(const Vector2& place) const {
    std::vector<Index> ends;
    for (const Object& object : map_.objects)
      if (object.type == ObjectType::wall)
        ends.insert(ends.end(), object.points.begin(), object.points.end());
    return nearest_point(map_, ends, place, parameters_.free_space.snap);
  }

  void add_start_area(std::size_t number) {
    const auto& edges = plan_.start_area[number];
    const auto outline = find_corners(plan_, edges);
    const Segment first = plan_.segment(edges.front());
    Object& area =
        add_object(ObjectType::start_area, outline.value_or(std::vector{first.a, first.b}),
                   "start area " + std::to_string(number));
    area.colour = kStartAreaColour;
  }

  const Object& object(Index index) const { return map_.objects[static_cast<std::size_t>(index)]; }

  const Floorplan& plan_;
  const std::vector<Surface>& surfaces_;
  const GlobalMapParameters& parameters_;
  Map map_;
  std::vector<Index> wall_of_;   ///< by surface
  std::vector<Index> cabinets_;  ///< by number
};

}  // namespace

GlobalMap make_global_map(const Floorplan& plan, const GlobalMapParameters& parameters) {
  const FreeSpace space = find_free_space(plan, parameters.free_space);
  const Surfaces surfaces =
      find_surfaces(space, {parameters.free_space.snap, parameters.straight_angle});
  GlobalMap result;
  result.map = Builder(plan, surfaces, parameters).build();
  result.id = content_id(result.map);
  result.hidden_length = surfaces.hidden_length;
  return result;
}

}  // namespace perceptor::global_map
