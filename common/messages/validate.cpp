#include "common/messages/validate.hpp"

#include <algorithm>
#include <cstddef>

#include "common/messages/plausible.hpp"

namespace perceptor::messages {
namespace {

template <class Item>
bool counts(std::int32_t count, const std::vector<Item>& items) {
  return count >= 0 && static_cast<std::size_t>(count) == items.size();
}

bool is_range_of_distances(double valid_min, double valid_max) {
  return is_length(valid_min) && is_length(valid_max) && valid_min < valid_max;
}

/// As many beams as fit between the first and the last bearing, both included.
double beams_of_angles(const pico::laser_scan_t& scan) {
  const double sweep = scan.angle_max - scan.angle_min;
  const bool is_one_beam = sweep == 0.0;
  return is_one_beam ? 1.0 : std::round(sweep / scan.angle_increment) + 1.0;
}

std::string_view fault_of_bearings(const pico::laser_scan_t& scan) {
  if (!is_angle(scan.angle_min) || !is_angle(scan.angle_max) || !is_angle(scan.angle_increment))
    return "angles out of range";
  const bool is_regular = scan.num_bearings == 0;
  if (is_regular) {
    const bool match = beams_of_angles(scan) == static_cast<double>(scan.num_ranges);
    return match ? "" : "number of beams does not match the angles";
  }
  if (scan.num_bearings != scan.num_ranges) return "number of beams does not match the bearings";
  if (scan.num_bearings > kMaxIrregularBeams) return "too many beams";
  const bool all_angles = std::ranges::all_of(scan.bearings, [](float a) { return is_angle(a); });
  return all_angles ? "" : "bearing out of range";
}

bool is_good(const pico::door_truth_t& door) {
  return is_coordinate(door.x1) && is_coordinate(door.y1) && is_coordinate(door.x2) &&
         is_coordinate(door.y2) && is_ratio(door.open_ratio);
}

bool is_good(const pico::mover_truth_t& mover) {
  return is_coordinate(mover.x) && is_coordinate(mover.y) && is_speed(mover.vx) &&
         is_speed(mover.vy) && is_length(mover.radius);
}

bool is_good(const pico::status_input_t& input) {
  const bool is_known_state =
      input.state >= pico::status_input_t::WAITING && input.state <= pico::status_input_t::STALE;
  return is_known_state && is_count(input.received) && is_count(input.rejected) &&
         is_count(input.missed) && is_count(input.restarts) && is_utime(input.last_utime);
}

bool is_good(const pico::status_reject_t& reject) { return is_count(reject.count); }

bool is_good(const pico::status_output_t& output) {
  return is_count(output.published) && output.last_seq >= -1 && output.last_seq <= kMaxCount;
}

template <class Item>
bool all_good(const std::vector<Item>& items) {
  return std::ranges::all_of(items, [](const Item& item) { return is_good(item); });
}

}  // namespace

std::string_view validate(const pico::laser_scan_t& scan) {
  if (const auto fault = fault_of_stamp(scan); !fault.empty()) return fault;
  if (!counts(scan.num_ranges, scan.ranges) || !counts(scan.num_bearings, scan.bearings))
    return "count differs from the array";
  if (scan.num_ranges < 1) return "no beams";
  if (scan.num_ranges > kMaxBeams) return "too many beams";
  if (const auto fault = fault_of_bearings(scan); !fault.empty()) return fault;
  if (!is_range_of_distances(scan.valid_min, scan.valid_max)) return "valid range out of range";
  const bool is_sigma = scan.range_sigma >= kMinRangeSigma && is_length(scan.range_sigma);
  if (!is_sigma) return "range_sigma out of range";
  const double sweep_time = (scan.num_ranges - 1) * scan.time_increment;
  const bool is_sweep = is_not_negative(scan.time_increment) && sweep_time < kMaxSweepTime;
  if (!is_sweep) return "time_increment out of range";
  if (!is_pose(scan.laser_in_robot)) return "laser_in_robot out of range";
  return {};
}

std::string_view validate(const pico::odometry_t& odometry) {
  if (const auto fault = fault_of_stamp(odometry); !fault.empty()) return fault;
  return is_pose(odometry.robot_in_odometry) ? "" : "robot_in_odometry out of range";
}

std::string_view validate(const pico::sonar_t& sonar) {
  if (const auto fault = fault_of_stamp(sonar); !fault.empty()) return fault;
  if (!counts(sonar.num_sonars, sonar.distances) || !counts(sonar.num_sonars, sonar.sonar_in_robot))
    return "count differs from the array";
  if (!is_range_of_distances(sonar.valid_min, sonar.valid_max)) return "valid range out of range";
  const bool is_cone = sonar.field_of_view > 0.0 && is_angle(sonar.field_of_view);
  if (!is_cone) return "field_of_view out of range";
  if (!std::ranges::all_of(sonar.sonar_in_robot, is_pose)) return "sonar_in_robot out of range";
  return {};
}

std::string_view validate(const pico::velocity_t& velocity) {
  if (const auto fault = fault_of_stamp(velocity); !fault.empty()) return fault;
  const bool is_good_velocity =
      is_speed(velocity.vx) && is_speed(velocity.vy) && is_speed(velocity.va);
  return is_good_velocity ? "" : "velocity out of range";
}

std::string_view validate(const pico::open_door_t& request) {
  if (const auto fault = fault_of_stamp(request); !fault.empty()) return fault;
  return request.door >= -1 ? "" : "door out of range";
}

std::string_view validate(const pico::speak_t& speech) {
  if (const auto fault = fault_of_stamp(speech); !fault.empty()) return fault;
  return speech.text.size() <= kMaxSpeech ? "" : "text too long";
}

std::string_view validate(const pico::truth_t& truth) {
  if (const auto fault = fault_of_stamp(truth); !fault.empty()) return fault;
  if (!counts(truth.num_doors, truth.doors) || !counts(truth.num_movers, truth.movers))
    return "count differs from the array";
  if (!is_pose(truth.robot_in_world)) return "robot_in_world out of range";
  if (!is_speed(truth.vx) || !is_speed(truth.vy) || !is_speed(truth.va))
    return "velocity out of range";
  if (!all_good(truth.doors)) return "door out of range";
  if (!all_good(truth.movers)) return "mover out of range";
  return {};
}

std::string_view validate(const pico::position_t& position) {
  if (const auto fault = fault_of_stamp(position); !fault.empty()) return fault;
  if (!is_utime(position.zero_utime)) return "zero_utime out of range";
  if (!is_pose(position.zero_in_odometry)) return "zero_in_odometry out of range";
  if (!is_pose(position.robot_in_zero)) return "robot_in_zero out of range";
  if (position.bridged < 0) return "bridged is negative";
  return {};
}

std::string_view validate(const pico::proximity_t& proximity) {
  if (const auto fault = fault_of_stamp(proximity); !fault.empty()) return fault;
  const std::int32_t sectors = proximity.num_sectors;
  if (!counts(sectors, proximity.too_close) || !counts(sectors, proximity.blind) ||
      !counts(sectors, proximity.contact) || !counts(sectors, proximity.distances) ||
      !counts(sectors, proximity.bearings))
    return "count differs from the array";
  if (sectors < 1) return "no sectors";
  // Infinity is allowed: nothing seen.
  const auto is_distance = [](double value) { return value >= 0.0; };
  if (!is_length(proximity.radius)) return "radius out of range";
  if (!is_distance(proximity.nearest_distance) ||
      !std::ranges::all_of(proximity.distances, is_distance))
    return "distance out of range";
  if (!is_angle(proximity.nearest_bearing) || !std::ranges::all_of(proximity.bearings, is_angle))
    return "bearing out of range";
  return {};
}

std::string_view validate(const pico::entrance_t& entrance) {
  if (const auto fault = fault_of_stamp(entrance); !fault.empty()) return fault;
  const bool is_opening = is_coordinate(entrance.middle_x) && is_coordinate(entrance.middle_y) &&
                          is_angle(entrance.direction) && is_length(entrance.width);
  if (!is_opening) return "opening out of range";
  if (!is_ratio(entrance.confidence)) return "confidence out of range";
  const bool is_hallway = is_coordinate(entrance.centre_x1) && is_coordinate(entrance.centre_y1) &&
                          is_coordinate(entrance.centre_x2) && is_coordinate(entrance.centre_y2) &&
                          is_length(entrance.hallway_width);
  if (!is_hallway) return "hallway out of range";
  return {};
}

std::string_view validate(const pico::world_position_t& position) {
  if (const auto fault = fault_of_stamp(position); !fault.empty()) return fault;
  if (!is_utime(position.zero_utime)) return "zero_utime out of range";
  if (position.state < pico::world_position_t::SEARCHING ||
      position.state > pico::world_position_t::LOST)
    return "unknown state";
  if (!is_pose(position.robot_in_world)) return "robot_in_world out of range";
  if (!std::ranges::all_of(position.covariance, [](double c) { return std::isfinite(c); }))
    return "covariance out of range";
  if (position.places < 0) return "places is negative";
  if (!is_ratio(position.explained) || !is_ratio(position.through)) return "share out of range";
  return {};
}

std::string_view validate(const pico::status_t& status) {
  if (const auto fault = fault_of_stamp(status); !fault.empty()) return fault;
  if (!counts(status.num_inputs, status.inputs) || !counts(status.num_rejects, status.rejects) ||
      !counts(status.num_outputs, status.outputs))
    return "count differs from the array";
  if (status.component.empty()) return "component without a name";
  if (!all_good(status.inputs)) return "input out of range";
  if (!all_good(status.rejects)) return "reject out of range";
  if (!all_good(status.outputs)) return "output out of range";
  const bool is_timing = is_count(status.processed) && is_not_negative(status.p50_us) &&
                         is_not_negative(status.p99_us) && is_not_negative(status.max_us);
  if (!is_timing) return "processing time out of range";
  const bool is_usage = is_count(status.rss_bytes) && is_not_negative(status.cpu_s);
  if (!is_usage) return "memory or processor time out of range";
  return {};
}

}  // namespace perceptor::messages
