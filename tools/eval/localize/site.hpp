/// @file A building in which localize is put to the test: its map file, and what of it the robot
/// meets.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/floorplan/floorplan.hpp"
#include "components/localize/world.hpp"

namespace perceptor {

struct Site {
  std::string name;
  std::filesystem::path file;  ///< what localize reads
  Floorplan plan;
  localize::World world;
  /// Openings that a door may shut [m] world frame, free space on their left: one for each face of
  /// the wall that they are in.
  std::vector<Segment> openings;
};

/// Throws config::Error.
Site read_site(const std::filesystem::path& file);

/// Walls and the sides of cabinets [m] world frame.
std::vector<Segment> lines(const Floorplan& plan);

/// A leaf for each opening. `recess` [m]: set back from the face, but not beyond the wall's other
/// face, where a wall as thick as a wall has one: there it stands in the middle.
std::vector<Segment> leaves(const std::vector<Segment>& openings, double recess);

}  // namespace perceptor
