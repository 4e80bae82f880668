#include "tests/support/message_samples.hpp"

#include <limits>

#include "common/messages/convert.hpp"

namespace perceptor::messages {

template <>
pico::laser_scan_t sample() {
  auto scan = stamped<pico::laser_scan_t>();
  scan.laser_in_robot = to_message({0.3, 0.0, 0.0});
  scan.time_increment = 2e-5;
  scan.angle_min = -0.2;
  scan.angle_max = 0.2;
  scan.angle_increment = 0.1;
  scan.valid_min = 0.1;
  scan.valid_max = 10.0;
  scan.range_sigma = 0.01;
  scan.ranges = {1.0F, std::numeric_limits<float>::quiet_NaN(), -1.0F, 1e30F, 2.5F};
  scan.num_ranges = 5;
  return scan;
}

template <>
pico::odometry_t sample() {
  auto odometry = stamped<pico::odometry_t>();
  odometry.robot_in_odometry = to_message({1.0, 2.0, 3.0});
  return odometry;
}

template <>
pico::sonar_t sample() {
  auto sonar = stamped<pico::sonar_t>();
  sonar.valid_min = 0.1;
  sonar.valid_max = 3.0;
  sonar.field_of_view = 0.3;
  sonar.num_sonars = 2;
  sonar.sonar_in_robot = {to_message({0.1, 0.1, 0.5}), to_message({0.1, -0.1, -0.5})};
  sonar.distances = {0.5, std::numeric_limits<double>::infinity()};
  return sonar;
}

template <>
pico::velocity_t sample() {
  auto velocity = stamped<pico::velocity_t>();
  velocity.vx = 0.5;
  velocity.va = -1.2;
  return velocity;
}

template <>
pico::open_door_t sample() {
  auto request = stamped<pico::open_door_t>();
  request.door = -1;
  return request;
}

template <>
pico::speak_t sample() {
  auto speech = stamped<pico::speak_t>();
  speech.text = "I am at the door";
  return speech;
}

template <>
pico::truth_t sample() {
  auto truth = stamped<pico::truth_t>();
  truth.robot_in_world = to_message({1.0, 2.0, 3.0});
  truth.vx = 0.5;
  truth.in_collision = 1;
  truth.doors.resize(2);
  truth.num_doors = 2;
  truth.doors[0].x2 = 1.0;
  truth.doors[1].open_ratio = 1.0;
  truth.movers.resize(1);
  truth.num_movers = 1;
  truth.movers[0].vx = 1.1;
  truth.movers[0].radius = 0.25;
  return truth;
}

template <>
pico::position_t sample() {
  auto position = stamped<pico::position_t>();
  position.zero_utime = 1'000'000;
  position.zero_in_odometry = to_message({5.0, 6.0, 1.0});
  position.robot_in_zero = to_message({1.0, 2.0, -1.0});
  position.bridged = 1;
  return position;
}

template <>
pico::proximity_t sample() {
  auto proximity = stamped<pico::proximity_t>();
  proximity.radius = 0.5;
  proximity.nearest_distance = 0.4;
  proximity.nearest_bearing = -2.0;
  proximity.num_sectors = 3;
  proximity.too_close = {1, 0, 0};
  proximity.blind = {0, 1, 0};
  proximity.contact = {0, 0, 0};
  proximity.distances = {0.4, std::numeric_limits<double>::infinity(), 2.0};
  proximity.bearings = {-2.0, 0.0, 2.0};
  return proximity;
}

template <>
pico::map_t sample() {
  Map map;
  const Segment along_x{Vector2(0.0, 0.0), Vector2(4.0, 0.0)};
  const Segment along_y{Vector2(4.0, 0.0), Vector2(4.0, 3.0)};
  add_segment(map, along_x, ObjectType::wall, "south");
  add_segment(map, along_y, ObjectType::possible_door, "door");
  connect(map, 1, 2);
  map.points[1].property = PointProperty::convex;
  map.points[1].covariance = Eigen::Matrix2d{{2e-4, 1e-5}, {1e-5, 1e-4}};
  map.points[3].projection = add_point(map, Vector2(4.0, 3.0));
  map.objects[0].line_covariance = Eigen::Matrix2d{{1e-4, 1e-6}, {1e-6, 1e-6}};
  map.objects[0].free_side = FreeSide::right;
  map.objects[1].confidence = 0.8;
  map.objects[1].reason = "two loose ends";
  auto message = make_map_message("robot", map);
  message.utime = 1'500'000;
  message.session = 42;
  message.seq = 7;
  message.map_id = 9;
  message.zero_utime = 1'000'000;
  message.robot_in_zero = to_message({1.0, 2.0, 3.0});
  message.robot_in_local = to_message({1.1, 2.1, 3.1});
  message.unobservable = 1;
  message.unobservable_direction = 0.5;
  for (const std::size_t diagonal : {0U, 4U, 8U})
    message.robot_in_local_covariance[diagonal] = 1e-3;
  return message;
}

template <>
pico::entrance_t sample() {
  auto entrance = stamped<pico::entrance_t>();
  entrance.entrance_found = 1;
  entrance.middle_x = 2.0;
  entrance.direction = 0.1;
  entrance.width = 0.9;
  entrance.confidence = 0.7;
  entrance.in_hallway = 1;
  entrance.centre_x2 = 3.0;
  entrance.hallway_width = 1.2;
  return entrance;
}

template <>
pico::world_position_t sample() {
  auto position = stamped<pico::world_position_t>();
  position.map_id = 17;
  position.zero_utime = 500'000;
  position.state = pico::world_position_t::TRACKING;
  position.robot_in_world = {1.0, 2.0, 0.5};
  position.places = 3;
  position.explained = 0.8;
  position.through = 0.01;
  return position;
}

template <>
pico::status_t sample() {
  pico::status_t status{};
  status.utime = 1'500'000;
  status.boot = 3;
  status.seq = 2;
  status.component = "scan";
  status.version = "0.1.0";
  status.note = "waits for POSITION";
  status.inputs.resize(1);
  status.num_inputs = 1;
  status.inputs[0].channel = "PICO_LASER";
  status.inputs[0].state = pico::status_input_t::OK;
  status.inputs[0].received = 10;
  status.rejects.resize(1);
  status.num_rejects = 1;
  status.rejects[0].channel = "PICO_LASER";
  status.rejects[0].reason = "truncated";
  status.rejects[0].count = 2;
  status.outputs.resize(1);
  status.num_outputs = 1;
  status.outputs[0].channel = "CURRENT_MAP";
  status.outputs[0].last_seq = -1;
  status.processed = 8;
  status.p50_us = 100.0;
  status.p99_us = 200.0;
  status.max_us = 300.0;
  status.rss_bytes = 8'000'000;
  status.cpu_s = 0.5;
  return status;
}

}  // namespace perceptor::messages
