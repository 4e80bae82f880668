/// @file A whole random world for the simulator: building, furniture, people, and a tour.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tools/eval/world_rooms.hpp"
#include "tools/eval/world_tour.hpp"

namespace perceptor {

struct RandomWorldParameters {
  std::uint64_t seed = 1;
  double sigma = 0.01;          ///< [m] standard deviation of a range
  double outliers = 0.0;        ///< share of beams that measure anything
  double slip = 0.05;           ///< each axis of odometry is wrong by a factor of 1 +- up to this
  double clearance = 0.3;       ///< [m] that the tour keeps from everything
  double furniture_gap = 0.42;  ///< [m] between the tour and cabinets or boxes
  double cabinets = 0.5;        ///< share of rooms with a cabinet
  double boxes = 0.5;           ///< share of rooms with a box
  int max_people = 3;           ///< one to so many walk about
  WorldRoomParameters rooms;
  WorldTourParameters tour;
};

/// A rectangle [m] world frame; x along its length.
struct Furniture {
  Position in_world;
  double length = 0.5;
  double width = 0.4;
};

/// [m] A person stands still for a robot that is nearer, and the robot for a person. Where a
/// person's way ends neither may be: they would wait for each other for ever.
inline constexpr double kWaitsWithin = 0.6;
inline constexpr double kGivesWayWithin = 0.65;

struct Walker {
  Segment path;        ///< [m] world frame, walked there and back
  double speed = 0.7;  ///< [m/s]
};

struct RandomWorld {
  WorldRooms rooms;
  std::vector<Furniture> cabinets;
  std::vector<Furniture> boxes;
  std::vector<Walker> people;
  std::vector<TourStop> tour;
  Position start_in_world;
  Position start_in_odometry;
};

/// The four sides in order, counter-clockwise.
std::vector<Segment> sides(const Furniture& furniture);

/// Seed and number give the same world on every machine, whatever else is drawn.
RandomWorld draw_random_world(const RandomWorldParameters& parameters, std::size_t number);

}  // namespace perceptor
