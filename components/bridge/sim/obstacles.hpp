/// @file What stands in the simulated world at one moment.
#pragma once

#include <vector>

#include "components/bridge/sim/shapes.hpp"

namespace perceptor::sim {

struct Obstacles {
  std::vector<Segment> segments;  ///< walls, cabinets, boxes, door leaves [m] world frame
  std::vector<Circle> bodies;     ///< what the base collides with: people
  std::vector<Circle> legs;       ///< what the laser sees of them
};

}  // namespace perceptor::sim
