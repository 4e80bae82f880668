#include "common/messages/convert.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "common/geometry/angle.hpp"
#include "common/model/map_parts.hpp"

namespace perceptor {
namespace {

using Covariance = std::optional<Eigen::Matrix2d>;

/// On the wire: xx, xy, yy; xx < 0 is "unknown".
Covariance covariance_from(const double (&wire)[3]) {
  if (wire[0] < 0.0) return std::nullopt;
  Eigen::Matrix2d covariance;
  covariance << wire[0], wire[1], wire[1], wire[2];
  return covariance;
}

void set_covariance(double (&wire)[3], const Covariance& covariance) {
  wire[0] = covariance ? (*covariance)(0, 0) : -1.0;
  wire[1] = covariance ? (*covariance)(0, 1) : 0.0;
  wire[2] = covariance ? (*covariance)(1, 1) : 0.0;
}

template <class Item>
std::int32_t count(const std::vector<Item>& items) {
  return static_cast<std::int32_t>(items.size());
}

Point to_model(const pico::map_point_t& wire) {
  Point point;
  point.location = {wire.x, wire.y};
  point.covariance = covariance_from(wire.covariance);
  point.property = static_cast<PointProperty>(wire.property);
  point.method = static_cast<CornerMethod>(wire.method);
  point.radius = wire.radius;
  point.weight = wire.weight;
  point.connected = wire.connected_point;
  point.projection = wire.projection_point;
  point.parents = wire.parents;
  return point;
}

void set_point(pico::map_point_t& wire, const Point& point) {
  wire.x = point.location.x();
  wire.y = point.location.y();
  set_covariance(wire.covariance, point.covariance);
  wire.property = static_cast<std::int8_t>(point.property);
  wire.method = static_cast<std::int8_t>(point.method);
  wire.radius = point.radius;
  wire.weight = point.weight;
  wire.connected_point = point.connected;
  wire.projection_point = point.projection;
  wire.num_parents = count(point.parents);
  wire.parents = point.parents;
}

Object to_model(const pico::map_object_t& wire) {
  Object object;
  object.id = wire.id;
  object.name = wire.name;
  object.type = static_cast<ObjectType>(wire.type);
  object.draw_type = static_cast<DrawType>(wire.draw_type);
  object.connection = static_cast<Connection>(wire.connection);
  object.colour = wire.colour;
  object.remove = wire.remove != 0;
  object.is_new = wire.is_new != 0;
  object.free_side = static_cast<FreeSide>(wire.free_side);
  object.support = wire.support;
  object.weight = wire.weight;
  object.confidence = wire.confidence;
  object.line_covariance = covariance_from(wire.line_covariance);
  object.first_seen = wire.first_seen;
  object.last_seen = wire.last_seen;
  object.reason = wire.reason;
  object.points = wire.points;
  return object;
}

void set_object(pico::map_object_t& wire, const Object& object) {
  wire.id = object.id;
  wire.name = object.name;
  wire.type = static_cast<std::int8_t>(object.type);
  wire.draw_type = static_cast<std::int8_t>(object.draw_type);
  wire.connection = static_cast<std::int8_t>(object.connection);
  wire.colour = object.colour;
  wire.remove = object.remove ? 1 : 0;
  wire.is_new = object.is_new ? 1 : 0;
  wire.free_side = static_cast<std::int8_t>(object.free_side);
  wire.support = object.support;
  wire.weight = object.weight;
  wire.confidence = object.confidence;
  set_covariance(wire.line_covariance, object.line_covariance);
  wire.first_seen = object.first_seen;
  wire.last_seen = object.last_seen;
  wire.reason = object.reason;
  wire.num_points = count(object.points);
  wire.points = object.points;
}

}  // namespace

Position to_model(const pico::pose_t& pose) { return {pose.x, pose.y, wrap_angle(pose.a)}; }

pico::pose_t to_message(const Position& position) {
  pico::pose_t pose{};
  pose.x = position.x;
  pose.y = position.y;
  pose.a = position.a;
  return pose;
}

LaserScan to_model(const pico::laser_scan_t& scan) {
  LaserScan model;
  model.laser_in_robot = to_model(scan.laser_in_robot);
  model.time_increment = scan.time_increment;
  model.valid_min = scan.valid_min;
  model.valid_max = scan.valid_max;
  model.range_sigma = scan.range_sigma;
  model.ranges.assign(scan.ranges.begin(), scan.ranges.end());
  const bool is_irregular = !scan.bearings.empty();
  if (is_irregular) {
    model.bearings.assign(scan.bearings.begin(), scan.bearings.end());
    return model;
  }
  model.bearings.reserve(model.size());
  for (std::size_t beam = 0; beam < model.size(); ++beam) {
    const auto steps = static_cast<double>(beam);
    model.bearings.push_back(scan.angle_min + steps * scan.angle_increment);
  }
  return model;
}

Map to_model(const pico::map_t& message) {
  Map map;
  map.points.reserve(message.points.size());
  map.objects.reserve(message.objects.size());
  for (const pico::map_point_t& point : message.points) map.points.push_back(to_model(point));
  for (const pico::map_object_t& object : message.objects) map.objects.push_back(to_model(object));
  return map;
}

void set_map(pico::map_t& message, const Map& map) {
  message.points.resize(map.points.size());
  message.objects.resize(map.objects.size());
  for (std::size_t i = 0; i < map.points.size(); ++i) set_point(message.points[i], map.points[i]);
  for (std::size_t i = 0; i < map.objects.size(); ++i)
    set_object(message.objects[i], map.objects[i]);
  message.num_points = count(message.points);
  message.num_objects = count(message.objects);
}

pico::map_t make_map_message(const std::string& frame, const Map& map) {
  pico::map_t message{};
  message.frame = frame;
  message.parts = 1;
  message.robot_in_local_covariance[0] = -1.0;
  set_map(message, map);
  return message;
}

std::vector<pico::map_t> make_map_messages(const std::string& frame, const Map& map,
                                           std::int64_t map_id) {
  // Some 180 bytes an object and 150 a point.
  constexpr std::size_t kObjectsInPart = 120;
  constexpr std::size_t kPointsInPart = 250;
  const std::vector<Map> parts = parts_of(map, kObjectsInPart, kPointsInPart);
  std::vector<pico::map_t> messages;
  for (const Map& part : parts) {
    pico::map_t message = make_map_message(frame, part);
    message.map_id = map_id;
    message.part = static_cast<std::int32_t>(messages.size());
    message.parts = static_cast<std::int32_t>(parts.size());
    messages.push_back(std::move(message));
  }
  return messages;
}

}  // namespace perceptor
