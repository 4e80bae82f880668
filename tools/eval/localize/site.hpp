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
};

/// Throws config::Error.
Site read_site(const std::filesystem::path& file);

/// Walls and the sides of cabinets [m] world frame.
std::vector<Segment> lines(const Floorplan& plan);

/// What shuts a doorway flush with the wall on either side.
std::vector<Segment> flush_leaves(const localize::Doorway& doorway);

/// A leaf in the middle of the wall; `recess` [m] to one side of a wall without depth.
Segment recessed_leaf(const localize::Doorway& doorway, double recess);

}  // namespace perceptor
