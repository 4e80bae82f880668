/// @file How much of a scan the walls of a map explain.
#pragma once

#include <cstdint>
#include <vector>

#include "common/model/laser_scan.hpp"
#include "common/model/map.hpp"

namespace perceptor {

struct ExplainedParameters {
  double max_range = 5.0;  ///< [m] longer beams are not counted: too coarse for short walls
  double reach = 0.05;     ///< [m] a beam that ends closer to a wall than this is explained
};

/// So many of so many.
struct Share {
  std::int64_t part = 0;
  std::int64_t whole = 0;

  Share& operator+=(const Share& other);
};

/// 0 where there is nothing to have a share of.
double value(const Share& share);

/// The ends and the walls in one frame. What is no wall of two points explains nothing, but a
/// beam that ends on the robot itself, where the map holds its outline, is not counted at all.
Share explained_beams(const std::vector<BeamEnd>& ends, const Map& map,
                      const std::vector<Vector2>& robot, const ExplainedParameters& parameters);

/// The outline of the robot in the map; empty where the map holds none.
std::vector<Vector2> robot_outline(const Map& map);

/// The walls of the map, with what is known of each.
std::vector<const Object*> walls_of(const Map& map);

}  // namespace perceptor
