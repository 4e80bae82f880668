/// @file The keys of a world file, bound to the simulator's parameters.
#pragma once

#include <string>
#include <vector>

#include "common/config/fields.hpp"
#include "common/config/robot.hpp"
#include "components/bridge/sim/simulator.hpp"

namespace perceptor::sim {

/// A point of the world [m].
struct Place {
  double x = 0.0;
  double y = 0.0;

  Vector2 location() const { return {x, y}; }
};

/// What the file says of a door: which one of the map, and everything but its place.
struct DoorEntry {
  int door = 0;
  DoorParameters parameters;
};

struct PersonEntry {
  std::vector<Place> path;
  PersonParameters parameters;
};

struct WaypointEntry {
  Place place;
  Waypoint parameters;
};

/// A whole file. Places of doors and walls come from the map, later.
struct WorldFile {
  std::string map;
  std::vector<DoorEntry> doors;
  std::vector<PersonEntry> people;
  std::vector<WaypointEntry> tour;
  SimulatorParameters simulator;
};

void describe(config::Fields& fields, Place& place);
void describe(config::Fields& fields, DoorEntry& entry);
void describe(config::Fields& fields, Box& box);
void describe(config::Fields& fields, PersonEntry& entry);
void describe(config::Fields& fields, WaypointEntry& entry);
void describe(config::Fields& fields, OdometryParameters& odometry);
void describe(config::Fields& fields, LaserParameters& laser);
void describe(config::Fields& fields, TourParameters& tour);
void describe(config::Fields& fields, WorldFile& world);

}  // namespace perceptor::sim
