#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "common/messages/plausible.hpp"
#include "common/messages/validate.hpp"
#include "common/model/map.hpp"

namespace perceptor::messages {
namespace {

constexpr std::array<std::string_view, 4> kFrames = {"robot", "zero", "local", "world"};

bool is_index(Index index, std::int32_t size) { return index >= 0 && index < size; }

bool is_index_or_none(Index index, std::int32_t size) {
  return index == kNone || is_index(index, size);
}

bool are_indices(const std::vector<Index>& indices, std::int32_t size) {
  return std::ranges::all_of(indices, [size](Index index) { return is_index(index, size); });
}

/// Of a number on the wire, an enumeration from 0 to `last`.
template <class Enumeration>
bool is_known(std::int8_t value, Enumeration last) {
  return value >= 0 && value <= static_cast<std::int8_t>(last);
}

template <class Item>
bool counts(std::int32_t count, const std::vector<Item>& items) {
  return count >= 0 && static_cast<std::size_t>(count) == items.size();
}

bool is_unknown_or_covariance(const double (&wire)[3]) {
  return wire[0] < 0.0 || is_covariance(wire[0], wire[1], wire[2]);
}

/// Rows x, y, a; each pair of them has to be one of two numbers. Whoever multiplies matrices
/// gets two halves that differ by rounding.
bool is_unknown_or_covariance(const double (&wire)[9]) {
  if (wire[0] < 0.0) return true;
  const double rounding = 1e-9 * (wire[0] + wire[4] + wire[8]);
  const bool is_symmetric = std::abs(wire[1] - wire[3]) <= rounding &&
                            std::abs(wire[2] - wire[6]) <= rounding &&
                            std::abs(wire[5] - wire[7]) <= rounding;
  return is_symmetric && is_covariance(wire[0], wire[1], wire[4]) &&
         is_covariance(wire[0], wire[2], wire[8]) && is_covariance(wire[4], wire[5], wire[8]);
}

bool has_two_points(std::int8_t type) {
  return type == pico::map_object_t::WALL || type == pico::map_object_t::DOOR ||
         type == pico::map_object_t::POSSIBLE_DOOR;
}

std::string_view fault_of(const pico::map_point_t& point, const pico::map_t& map) {
  if (!counts(point.num_parents, point.parents)) return "count differs from the array";
  if (!is_coordinate(point.x) || !is_coordinate(point.y)) return "location of a point out of range";
  if (!is_unknown_or_covariance(point.covariance)) return "covariance of a point out of range";
  if (!is_known(point.property, PointProperty::concave) ||
      !is_known(point.method, CornerMethod::map))
    return "unknown kind of point";
  if (!is_length(point.radius)) return "radius of a point out of range";
  if (!is_not_negative(point.weight)) return "weight of a point out of range";
  if (!is_index_or_none(point.connected_point, map.num_points) ||
      !is_index_or_none(point.projection_point, map.num_points) ||
      !are_indices(point.parents, map.num_objects))
    return "reference of a point out of range";
  return {};
}

std::string_view fault_of(const pico::map_object_t& object, const pico::map_t& map) {
  if (!counts(object.num_points, object.points)) return "count differs from the array";
  if (object.name.size() > kMaxNameLength) return "name of an object too long";
  if (!is_known(object.type, ObjectType::start_area) ||
      !is_known(object.draw_type, DrawType::lines) ||
      !is_known(object.connection, Connection::closed))
    return "unknown kind of object";
  if (object.colour < 0 || object.colour > 0xFFFFFF) return "colour out of range";
  if (object.free_side < -1 || object.free_side > 1) return "free side out of range";
  if (object.support < 0 || !is_not_negative(object.weight) || !is_ratio(object.confidence))
    return "certainty of an object out of range";
  if (!is_unknown_or_covariance(object.line_covariance))
    return "covariance of an object out of range";
  if (!is_utime(object.first_seen) || !is_utime(object.last_seen))
    return "utime of an object out of range";
  if (object.points.empty()) return "object without points";
  if (has_two_points(object.type) && object.points.size() != 2)
    return "wall or door without two points";
  if (!are_indices(object.points, map.num_points)) return "reference of an object out of range";
  return {};
}

bool projects_on_itself(const pico::map_t& map) {
  for (Index i = 0; i < map.num_points; ++i) {
    if (map.points[static_cast<std::size_t>(i)].projection_point == i) return true;
  }
  return false;
}

/// Whether each connected point is connected to another that is connected to it.
bool is_mutual(const pico::map_t& map) {
  for (Index i = 0; i < map.num_points; ++i) {
    const Index other = map.points[static_cast<std::size_t>(i)].connected_point;
    if (other == kNone) continue;
    if (other == i || map.points[static_cast<std::size_t>(other)].connected_point != i)
      return false;
  }
  return true;
}

using Membership = std::pair<Index, Index>;  // object, point

std::vector<Membership> sorted_once(std::vector<Membership> memberships) {
  std::ranges::sort(memberships);
  const auto repeated = std::ranges::unique(memberships);
  memberships.erase(repeated.begin(), repeated.end());
  return memberships;
}

/// Whether the objects' points and the points' parents tell the same.
bool is_agreed(const pico::map_t& map) {
  std::vector<Membership> by_object;
  for (Index i = 0; i < map.num_objects; ++i) {
    for (const Index point : map.objects[static_cast<std::size_t>(i)].points)
      by_object.emplace_back(i, point);
  }
  std::vector<Membership> by_point;
  for (Index i = 0; i < map.num_points; ++i) {
    for (const Index parent : map.points[static_cast<std::size_t>(i)].parents)
      by_point.emplace_back(parent, i);
  }
  return sorted_once(std::move(by_object)) == sorted_once(std::move(by_point));
}

/// Of one map: 60 megabytes.
constexpr std::int32_t kMaxParts = 1000;

std::string_view fault_of_head(const pico::map_t& map) {
  if (const auto fault = fault_of_stamp(map); !fault.empty()) return fault;
  if (std::ranges::find(kFrames, map.frame) == kFrames.end()) return "unknown frame";
  const bool is_part = map.part >= 0 && map.part < map.parts;
  if (!is_part) return "part out of range";
  if (map.parts > kMaxParts) return "too many parts";
  if (!is_utime(map.zero_utime)) return "zero_utime out of range";
  if (!is_pose(map.robot_in_zero)) return "robot_in_zero out of range";
  if (!is_pose(map.laser_in_robot)) return "laser_in_robot out of range";
  if (!is_pose(map.robot_in_local)) return "robot_in_local out of range";
  if (!is_unknown_or_covariance(map.robot_in_local_covariance))
    return "robot_in_local_covariance out of range";
  if (!is_angle(map.unobservable_direction)) return "unobservable_direction out of range";
  if (!counts(map.num_points, map.points) || !counts(map.num_objects, map.objects))
    return "count differs from the array";
  if (map.num_points > kMaxMapPoints) return "too many points";
  if (map.num_objects > kMaxMapObjects) return "too many objects";
  return {};
}

}  // namespace

std::string_view validate(const pico::map_t& map) {
  if (const auto fault = fault_of_head(map); !fault.empty()) return fault;
  for (const pico::map_point_t& point : map.points) {
    if (const auto fault = fault_of(point, map); !fault.empty()) return fault;
  }
  for (const pico::map_object_t& object : map.objects) {
    if (const auto fault = fault_of(object, map); !fault.empty()) return fault;
  }
  if (projects_on_itself(map)) return "point projected on itself";
  if (!is_mutual(map)) return "one-sided connection of points";
  if (!is_agreed(map)) return "points and objects disagree";
  return {};
}

}  // namespace perceptor::messages
