#include "components/bridge/sim_messages.hpp"

#include <string>
#include <utility>

#include "common/messages/convert.hpp"

namespace perceptor {
namespace {

/// Objects in one part of the world: some 250 bytes each.
constexpr std::size_t kObjectsInPart = 150;

/// Above this ratio one can see through a door.
constexpr double kOpenRatio = 0.5;

/// Collects objects, and begins another part when one is full.
class Parts {
 public:
  Object& add(const Segment& segment, ObjectType type, const char* name) {
    if (maps_.empty() || maps_.back().objects.size() == kObjectsInPart) maps_.emplace_back();
    Map& map = maps_.back();
    const Index index = add_segment(map, segment, type, name);
    Object& object = map.objects[static_cast<std::size_t>(index)];
    object.id = next_id_++;
    object.is_new = false;
    return object;
  }

  std::vector<pico::map_t> messages() const {
    std::vector<pico::map_t> messages;
    for (const Map& map : maps_) {
      pico::map_t message = make_map_message("world", map);
      message.part = static_cast<std::int32_t>(messages.size());
      message.parts = static_cast<std::int32_t>(maps_.size());
      messages.push_back(std::move(message));
    }
    return messages;
  }

 private:
  std::vector<Map> maps_;
  std::int32_t next_id_ = 0;
};

}  // namespace

pico::laser_scan_t to_message(const sim::Sweep& sweep, const sim::LaserParameters& laser,
                              const LaserMounting& mounting) {
  pico::laser_scan_t message{};
  message.laser_in_robot = to_message(mounting.laser_in_robot);
  message.time_increment = sim::time_increment(laser);
  message.angle_min = laser.angle_min;
  message.angle_increment = sim::angle_increment(laser);
  message.angle_max = laser.beams > 1 ? laser.angle_max : laser.angle_min;
  message.valid_min = mounting.valid_min;
  message.valid_max = mounting.valid_max;
  message.range_sigma = mounting.range_sigma;
  message.num_ranges = static_cast<std::int32_t>(sweep.ranges.size());
  message.ranges = sweep.ranges;
  message.num_bearings = 0;
  return message;
}

pico::odometry_t to_message(const sim::OdometryReading& reading) {
  pico::odometry_t message{};
  message.robot_in_odometry = to_message(reading.robot_in_odometry);
  return message;
}

pico::truth_t to_message(const sim::Truth& truth) {
  pico::truth_t message{};
  message.robot_in_world = to_message(truth.robot_in_world);
  message.vx = truth.twist.vx;
  message.vy = truth.twist.vy;
  message.va = truth.twist.va;
  message.in_collision = truth.in_collision ? 1 : 0;
  for (const sim::DoorState& door : truth.doors) {
    pico::door_truth_t state{};
    state.x1 = door.opening.a.x();
    state.y1 = door.opening.a.y();
    state.x2 = door.opening.b.x();
    state.y2 = door.opening.b.y();
    state.open_ratio = door.open_ratio;
    message.doors.push_back(state);
  }
  for (const sim::MoverState& mover : truth.movers) {
    pico::mover_truth_t state{};
    state.x = mover.body.centre.x();
    state.y = mover.body.centre.y();
    state.vx = mover.velocity.x();
    state.vy = mover.velocity.y();
    state.radius = mover.body.radius;
    message.movers.push_back(state);
  }
  message.num_doors = static_cast<std::int32_t>(message.doors.size());
  message.num_movers = static_cast<std::int32_t>(message.movers.size());
  return message;
}

std::vector<pico::map_t> to_messages(const sim::World& world,
                                     const std::vector<sim::DoorState>& doors) {
  Parts parts;
  for (const Segment& wall : world.walls) parts.add(wall, ObjectType::wall, "wall");
  for (const Segment& edge : world.cabinets) parts.add(edge, ObjectType::cabinet, "cabinet");
  for (const sim::DoorState& door : doors)
    parts.add(door.opening, ObjectType::door, "door").reason =
        door.open_ratio > kOpenRatio ? "open" : "shut";
  for (const sim::Box& box : world.boxes)
    for (const Segment& edge : edges(sim::outline(box)))
      parts.add(edge, ObjectType::static_obstacle, "box");
  return parts.messages();
}

}  // namespace perceptor
