#include "components/bridge/world_fields.hpp"

#include <cstdint>
#include <numbers>

namespace perceptor::sim {
namespace {

constexpr config::Range kShare{0.0, 1.0};
constexpr config::Range kPlace{-1000.0, 1000.0};
constexpr config::Range kAngle{-std::numbers::pi, std::numbers::pi};
constexpr config::Range kDuration{0.0, 1e6};
/// Far above any number of things that a world holds.
constexpr std::int64_t kLargestIndex = 10'000;

}  // namespace

using config::Fields;

void describe(Fields& fields, Place& place) {
  fields.number("x", place.x, kPlace, "[m] world frame");
  fields.number("y", place.y, kPlace, "[m] world frame");
}

void describe(Fields& fields, DoorEntry& entry) {
  DoorParameters& door = entry.parameters;
  fields.integer("door", entry.door, {0, kLargestIndex}, "which of the map's doors, from 0");
  fields.choice("state", door.mode,
                {{"open", DoorMode::open},
                 {"shut", DoorMode::shut},
                 {"recessed", DoorMode::recessed},
                 {"on_request", DoorMode::on_request},
                 {"timed", DoorMode::timed}},
                "what the leaf does");
  fields.number("recess", door.recess, {-2.0, 2.0},
                "[m] of a recessed leaf, positive to the left of the opening");
  fields.number("travel_time", door.travel_time, {0.01, 60.0}, "[s] from shut to open");
  fields.number("open_for", door.open_for, kDuration,
                "[s] from the request, or the beginning of the period, until it shuts");
  fields.number("period", door.period, {0.1, 1e6}, "[s] of a timed door");
}

void describe(Fields& fields, Box& box) {
  fields.number("x", box.box_in_world.x, kPlace, "[m] of the middle, world frame");
  fields.number("y", box.box_in_world.y, kPlace, "[m] of the middle, world frame");
  fields.number("a", box.box_in_world.a, kAngle, "[rad] direction of its length");
  fields.number("length", box.length, {0.01, 100.0}, "[m]");
  fields.number("width", box.width, {0.01, 100.0}, "[m]");
}

void describe(Fields& fields, PersonEntry& entry) {
  PersonParameters& person = entry.parameters;
  fields.list("path", entry.path, "way-points, walked there and back");
  fields.number("speed", person.speed, {0.0, 5.0}, "[m/s]");
  fields.number("radius", person.radius, {0.05, 1.0}, "[m] of the body, for collisions");
  fields.boolean("two_legs", person.two_legs, "the laser sees two legs, otherwise the body");
  fields.number("leg_radius", person.leg_radius, {0.01, 0.5}, "[m]");
  fields.number("leg_separation", person.leg_separation, {0.0, 1.0}, "[m] between the legs");
  fields.number("stride", person.stride, {0.1, 3.0}, "[m] walked in a full cycle of the gait");
  fields.number("step_length", person.step_length, {0.0, 1.0},
                "[m] a leg is so far ahead or behind at most");
  fields.number("waits_within", person.waits_within, {0.0, 100.0},
                "[m] waits for a robot ahead that is nearer");
  fields.number("patience", person.patience, kDuration, "[s] of waiting, then turns back");
  fields.require(!entry.path.empty(), "path", "at least one way-point");
}

void describe(Fields& fields, WaypointEntry& entry) {
  Waypoint& waypoint = entry.parameters;
  describe(fields, entry.place);
  fields.number("turn", waypoint.turn, {-100.0, 100.0}, "[rad] turned in place after arrival");
  fields.number("pause", waypoint.pause, kDuration, "[s] stood still after that");
  fields.integer("open_door", waypoint.open_door, {-1, kLargestIndex},
                 "door that is asked for on arrival; -1: none");
}

void describe(Fields& fields, OdometryParameters& odometry) {
  fields.group("start_in_odometry", odometry.start_in_odometry,
               "where the wheels believe to be at the start");
  fields.number("rate", odometry.rate, {0.1, 1000.0}, "[Hz]");
  fields.number("slip_scale", odometry.slip_scale, {0.0, 0.5},
                "each axis is wrong by a factor of 1 +- up to this");
  fields.number("slip_walk", odometry.slip_walk, {0.0, 1.0},
                "[m/sqrt(m)] scatter that grows with the distance");
  fields.number("slip_turn_walk", odometry.slip_turn_walk, {0.0, 1.0},
                "[rad/sqrt(rad)] scatter that grows with the angle");
  fields.number("noise", odometry.noise, {0.0, 1.0}, "[m] of one reading");
  fields.number("turn_noise", odometry.turn_noise, {0.0, 1.0}, "[rad] of one reading");
}

void describe(Fields& fields, LaserParameters& laser) {
  fields.integer("beams", laser.beams, {1, 10'000}, "in one sweep");
  fields.number("angle_min", laser.angle_min, {-6.3, 6.3}, "[rad] bearing of the first beam");
  fields.number("angle_max", laser.angle_max, {-6.3, 6.3}, "[rad] bearing of the last beam");
  fields.number("rate", laser.rate, {0.1, 1000.0}, "[Hz] sweeps");
  fields.number("sweep_time", laser.sweep_time, {0.0, 10.0},
                "[s] from the first beam to the last; 0: all at once");
  fields.number("range_max", laser.range_max, {0.1, 1000.0}, "[m] beyond it a beam is missed");
  fields.number("noise_sigma", laser.noise_sigma, {0.0, 1.0}, "[m] standard deviation");
  fields.choice("noise", laser.noise,
                {{"gaussian", NoiseKind::gaussian}, {"uniform", NoiseKind::uniform}},
                "its distribution");
  fields.number("outliers", laser.outliers, kShare, "share of returns that are anywhere");
  fields.number("missed", laser.missed, kShare, "share of returns that are lost");
  fields.choice("missed_value", laser.missed_value,
                {{"zero", MissedValue::zero},
                 {"inf", MissedValue::inf},
                 {"nan", MissedValue::nan},
                 {"range_max", MissedValue::range_max},
                 {"range_max_noise", MissedValue::range_max_noise},
                 {"negative", MissedValue::negative}},
                "how a missed beam is reported");
  fields.number("missed_noise", laser.missed_noise, {0.0, 1.0},
                "[m] of range_max_noise, to either side");
  fields.require(laser.angle_max > laser.angle_min, "angle_max", "above angle_min");
  const double shortest_gap = 1e-5;  // [s] between two sweeps
  fields.require(laser.sweep_time <= (1.0 / laser.rate) - shortest_gap, "sweep_time",
                 "less than the time between two sweeps");
}

void describe(Fields& fields, TourParameters& tour) {
  fields.boolean("loop", tour.loop, "from the last way-point to the first again");
  fields.number("speed", tour.speed, {0.01, 10.0}, "[m/s] along the way");
  fields.number("turn_rate", tour.turn_rate, {0.01, 10.0}, "[rad/s]");
  fields.number("acceleration", tour.acceleration, {0.01, 10.0}, "[m/s^2] when it slows down");
  fields.number("gain", tour.gain, {0.1, 10.0}, "[1/s] turn rate for each radian of error");
  fields.number("reach", tour.reach, {0.005, 1.0}, "[m] so near a way-point is reached");
  fields.number("turn_first", tour.turn_first, {0.05, 3.2},
                "[rad] a larger error is turned away on the spot");
  fields.number("gives_way_within", tour.gives_way_within, {0.0, 10.0},
                "[m] waits for a person ahead who is nearer");
  fields.number("gives_way_width", tour.gives_way_width, {0.0, 10.0},
                "[m] ahead means so far aside at most");
}

void describe(Fields& fields, WorldFile& world) {
  SimulatorParameters& simulator = world.simulator;
  fields.text("map", world.map, "map file, seen from this file's folder");
  fields.integer("seed", simulator.seed, {0, INT64_MAX}, "of all random numbers");
  fields.integer("start_utime", simulator.start_utime, {0, INT64_MAX / 2},
                 "[us] at which the simulation begins");
  fields.integer("tick", simulator.tick, {100, 20'000}, "[us] in which the world goes on");
  fields.group("start", simulator.start_in_world, "where the robot stands at first");
  fields.number("command_lifetime", simulator.command_lifetime, {0.0, 100.0},
                "[s] an older command stops the robot");
  fields.group("odometry", simulator.odometry, "the wheels");
  fields.group("laser", simulator.laser, "the laser");
  fields.list("doors", world.doors, "doors of the map that are not simply open");
  fields.list("boxes", simulator.world.boxes, "rotated rectangles");
  fields.list("people", world.people, "who walk there and back");
  fields.group("driver", simulator.tour, "how the tour is driven");
  fields.list("tour", world.tour, "way-points of the robot");
}

}  // namespace perceptor::sim
