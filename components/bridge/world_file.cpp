#include "components/bridge/world_file.hpp"

#include <utility>

#include "common/config/named_file.hpp"
#include "common/floorplan/floorplan.hpp"
#include "components/bridge/world_fields.hpp"

namespace perceptor::sim {
namespace {

/// A door that the map draws with several edges (an outline) moves as its longest one.
Segment opening(const Floorplan& map, const std::vector<Floorplan::Edge>& door) {
  Segment longest;
  for (const Floorplan::Edge& edge : door)
    if (length(map.segment(edge)) > length(longest)) longest = map.segment(edge);
  return longest;
}

void add_map(const Floorplan& map, World& world) {
  for (const Floorplan::Edge& wall : map.walls) world.walls.push_back(map.segment(wall));
  for (const auto& cabinet : map.cabinets)
    for (const Floorplan::Edge& edge : cabinet) world.cabinets.push_back(map.segment(edge));
  for (const auto& door : map.doors) {
    DoorParameters parameters;
    parameters.opening = opening(map, door);
    world.doors.push_back(parameters);
  }
}

}  // namespace

SimulatorParameters parameters_of(const Robot& robot) {
  SimulatorParameters parameters;
  parameters.base.footprint = outline(robot);
  parameters.base.speed = robot.limits.speed;
  parameters.base.turn_rate = robot.limits.turn_rate;
  parameters.base.acceleration = robot.limits.acceleration;
  parameters.base.angular_acceleration = robot.limits.angular_acceleration;
  parameters.laser.laser_in_robot = robot.laser.laser_in_robot;
  parameters.laser.valid_min = robot.laser.valid_min;
  parameters.laser.valid_max = robot.laser.valid_max;
  // Above valid_max with all its noise, as real sensors' own limit is.
  parameters.laser.range_max = robot.laser.valid_max + (2.0 * parameters.laser.missed_noise);
  parameters.laser.noise_sigma = robot.laser.range_sigma;
  return parameters;
}

}  // namespace perceptor::sim

namespace perceptor {

std::filesystem::path find_world(const std::string& world,
                                 const std::filesystem::path& config_dir) {
  return config::find_named("world", world, config_dir / "worlds");
}

sim::SimulatorParameters read_world(const std::filesystem::path& file, const Robot& robot) {
  sim::WorldFile world;
  world.simulator = sim::parameters_of(robot);
  config::load_file(file, [&](config::Fields& fields) { sim::describe(fields, world); });

  sim::SimulatorParameters parameters = std::move(world.simulator);
  sim::add_map(read_floorplan(file.parent_path() / world.map), parameters.world);
  std::vector<sim::DoorParameters>& doors = parameters.world.doors;
  const auto check_door = [&](int door, const std::string& pointer) {
    if (door < static_cast<int>(doors.size())) return;
    throw config::Error(file.string() + ": " + pointer + ": " + std::to_string(door) +
                        ": the map has " + std::to_string(doors.size()) + " doors");
  };
  for (std::size_t i = 0; i < world.doors.size(); ++i) {
    const sim::DoorEntry& entry = world.doors[i];
    check_door(entry.door, "/doors/" + std::to_string(i) + "/door");
    sim::DoorParameters& door = doors[static_cast<std::size_t>(entry.door)];
    const Segment opening = door.opening;
    door = entry.parameters;
    door.opening = opening;
  }
  for (sim::PersonEntry& entry : world.people) {
    for (const sim::Place& place : entry.path) entry.parameters.path.push_back(place.location());
    parameters.world.people.push_back(entry.parameters);
  }
  for (std::size_t i = 0; i < world.tour.size(); ++i) {
    sim::WaypointEntry& entry = world.tour[i];
    check_door(entry.parameters.open_door, "/tour/" + std::to_string(i) + "/open_door");
    entry.parameters.location = entry.place.location();
    parameters.tour.points.push_back(entry.parameters);
  }
  return parameters;
}

}  // namespace perceptor
